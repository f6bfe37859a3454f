// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <mujoco/mujoco.h>
#include <unistd.h>

#include "peers.h"

namespace arms {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class MuJoCo : public Peer {
 public:
  explicit MuJoCo(const std::string& mjcf) {
    const auto path =
        std::filesystem::temp_directory_path() / ("qvgen_arm_" + std::to_string(::getpid()) + ".xml");
    std::ofstream(path) << mjcf;
    char reason[1000] = "";
    model_ = mj_loadXML(path.c_str(), nullptr, reason, sizeof reason);
    std::filesystem::remove(path);
    if (model_ == nullptr) throw std::runtime_error(reason);
    data_ = mj_makeData(model_);
    body_ = mj_name2id(model_, mjOBJ_BODY, "tool0");
  }
  MuJoCo(const MuJoCo&) = delete;
  MuJoCo& operator=(const MuJoCo&) = delete;
  ~MuJoCo() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  Eigen::Isometry3d tool(const VectorXd& q) override {
    place(q);
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * body_);
    result.translation() = Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body_);
    return result;
  }
  MatrixXd jacobian(const VectorXd& q) override {
    place(q);
    RowMajor result(6, model_->nv);
    mj_jacBody(model_, data_, result.data(), result.data() + 3 * model_->nv, body_);
    return result;
  }
  VectorXd inverse_dynamics(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd) override {
    set(q, qd);
    Eigen::Map<VectorXd>(data_->qacc, model_->nv) = qdd;
    mj_inverse(model_, data_);
    return Eigen::Map<const VectorXd>(data_->qfrc_inverse, model_->nv);
  }
  VectorXd forward_dynamics(const VectorXd& q, const VectorXd& qd, const VectorXd& torque) override {
    set(q, qd);
    Eigen::Map<VectorXd>(data_->qfrc_applied, model_->nv) = torque;
    mj_forward(model_, data_);
    return Eigen::Map<const VectorXd>(data_->qacc, model_->nv);
  }

 private:
  void set(const VectorXd& q, const VectorXd& qd) {
    mj_resetData(model_, data_);
    Eigen::Map<VectorXd>(data_->qpos, model_->nq) = q;
    Eigen::Map<VectorXd>(data_->qvel, model_->nv) = qd;
  }
  void place(const VectorXd& q) {
    set(q, VectorXd::Zero(q.size()));
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
  }
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
  int body_ = 0;
};

}  // namespace

std::unique_ptr<Peer> mujoco(const std::string& mjcf) { return std::make_unique<MuJoCo>(mjcf); }

}  // namespace arms
