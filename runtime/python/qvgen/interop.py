# SPDX-License-Identifier: MIT
"""A robot's functions in CasADi, JAX and PyTorch, with the exact derivatives of qvgen.derivatives; its configurations in
Pinocchio and MuJoCo.

    f = qvgen.interop.casadi(arm, "forward_dynamics")     # a casadi.Function of q, qd, torque
    f = qvgen.interop.jax(arm, "forward_kinematics")      # takes arrays with any axes in front; jit, grad, vmap
    f = qvgen.interop.torch(arm, "inverse_dynamics")      # likewise; autograd
    x = qvgen.interop.pinocchio(arm, model).to_configuration(q)      # and back; or mujoco

All compute in float64 on the CPU and give the scalar that they got. First derivatives are exact. Second ones
are there for CasADi alone, as finite differences of the exact first ones.
"""

import numpy as np

from ._peers import Conversion, mujoco, pinocchio
from .derivatives import OF, arguments_of

__all__ = ["Conversion", "casadi", "jax", "mujoco", "pinocchio", "torch"]


def _flat(arm, arrays):
    """Arrays of equal axes in front as rows in float64, and these axes."""
    arrays = np.broadcast_arrays(*(np.asarray(each, np.float64) for each in arrays))
    front = arrays[0].shape[:-1]
    return [np.ascontiguousarray(each.reshape(-1, arm.dof)) for each in arrays], front


def _value(arm, name, *arrays):
    rows, front = _flat(arm, arrays)
    found = getattr(arm, name)(*rows)
    return found.reshape(*front, *found.shape[1:])


def _derivatives(arm, name, *arrays):
    """Derivatives by each argument, the arguments' axes in front."""
    rows, front = _flat(arm, arrays)
    return [each.reshape(*front, *each.shape[1:]) for each in OF[name][0](arm, *rows)[1]]


def _shape(arm, name, count):
    """Shape of a row of the result."""
    return _value(arm, name, *[np.zeros(arm.dof)] * count).shape


def casadi(arm, name):
    """A casadi.Function: arguments are columns of dof numbers, matrices are as they are; keep it alive as long as it is used."""
    arguments, dof = arguments_of(arm, name), arm.dof
    import casadi as cs
    shape = _shape(arm, name, len(arguments))
    rows, columns = shape if len(shape) == 2 else (*shape, 1)
    read = lambda given: [np.array(each).reshape(dof) for each in given[:len(arguments)]]

    class Jacobian(cs.Callback):
        def __init__(self, label, inputs, outputs, options):
            cs.Callback.__init__(self)
            self.inputs, self.outputs = inputs, outputs
            self.construct(label, {**options, "enable_fd": True})

        def get_n_in(self): return len(arguments) + 1
        def get_n_out(self): return len(arguments)
        def get_name_in(self, i): return self.inputs[i]
        def get_name_out(self, i): return self.outputs[i]
        def get_sparsity_in(self, i): return cs.Sparsity.dense(dof, 1) if i < len(arguments) else cs.Sparsity(rows, columns)
        def get_sparsity_out(self, i): return cs.Sparsity.dense(rows * columns, dof)

        def eval(self, given):  # CasADi's matrices are by columns
            found = _derivatives(arm, name, *read(given))
            return [np.moveaxis(each, 0, 1).reshape(rows * columns, dof) if len(shape) == 2 else each for each in found]

    class Value(cs.Callback):
        def __init__(self):
            cs.Callback.__init__(self)
            self.kept = []
            self.construct(f"{arm.__name__}_{name}", {})

        def get_n_in(self): return len(arguments)
        def get_n_out(self): return 1
        def get_name_in(self, i): return arguments[i]
        def get_name_out(self, i): return name
        def get_sparsity_in(self, i): return cs.Sparsity.dense(dof, 1)
        def get_sparsity_out(self, i): return cs.Sparsity.dense(rows, columns)
        def eval(self, given): return [_value(arm, name, *read(given))]
        def has_jacobian(self): return True

        def get_jacobian(self, label, inputs, outputs, options):
            self.kept.append(Jacobian(label, inputs, outputs, options))
            return self.kept[-1]

    return Value()


def jax(arm, name):
    """A function of JAX, of arrays (..., dof), under jit, vmap, jvp and grad."""
    arguments = arguments_of(arm, name)
    import jax
    import jax.numpy as jnp
    shape = _shape(arm, name, len(arguments))

    def called(function, shapes, arrays):
        arrays = jnp.broadcast_arrays(*arrays)
        kind, front = jnp.result_type(*arrays), arrays[0].shape[:-1]
        results = [jax.ShapeDtypeStruct((*front, *each), kind) for each in shapes]
        return jax.pure_callback(lambda *given: [each.astype(kind) for each in function(*given)], results, *arrays,
                                 vmap_method="broadcast_all")

    @jax.custom_jvp
    def value(*arrays):
        return called(lambda *given: [_value(arm, name, *given)], [shape], arrays)[0]

    @value.defjvp
    def tangent(arrays, rates):
        by = called(lambda *given: _derivatives(arm, name, *given), [(*shape, arm.dof)] * len(arguments), arrays)
        letters = "ab"[:len(shape)]
        return value(*arrays), sum(jnp.einsum(f"...{letters}i,...i->...{letters}", each, rate) for each, rate in zip(by, rates))

    value.__name__ = name
    return value


def torch(arm, name):
    """A function of PyTorch, of tensors (..., dof), with gradients."""
    arguments = arguments_of(arm, name)
    import torch
    letters = "ab"[:len(_shape(arm, name, len(arguments)))]

    class Function(torch.autograd.Function):
        @staticmethod
        def forward(context, *tensors):
            context.save_for_backward(*tensors)
            kind = torch.result_type(tensors[0], tensors[-1])
            return torch.from_numpy(_value(arm, name, *(each.detach().cpu().numpy() for each in tensors))).to(kind)

        @staticmethod
        @torch.autograd.function.once_differentiable
        def backward(context, gradient):
            tensors = context.saved_tensors
            by = _derivatives(arm, name, *(each.detach().cpu().numpy() for each in tensors))
            weights = gradient.detach().cpu().numpy().astype(np.float64)
            found = [torch.from_numpy(np.einsum(f"...{letters}i,...{letters}->...i", each, weights)).to(tensor)
                     for each, tensor in zip(by, tensors)]
            return tuple(each.sum_to_size(tensor.shape) for each, tensor in zip(found, tensors))

    def value(*tensors):
        if len(tensors) != len(arguments):
            raise TypeError(f"{name} takes {', '.join(arguments)}")
        return Function.apply(*tensors)

    value.__name__ = name
    return value
