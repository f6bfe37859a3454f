% SPDX-License-Identifier: MIT
function failures = check_vectors(robot, name, file, n, rows, sizes)
% Number of ways in which the columns of a file are not what a function gives: as a file of Octave, compiled, a column
% alone, and one column of the first argument with all of the others. Every bit counts; NaN is NaN.
handle = fopen(file);
given = arrayfun(@(r) fread(handle, [r, n * (r > 0)], 'double'), rows, 'UniformOutput', false);
wanted = cellfun(@(s) reshape(fread(handle, prod(s) * n, 'double'), [s, n]), sizes, 'UniformOutput', false);
assert(isempty(fread(handle, 1)) && feof(handle));
fclose(handle);
own = str2func(['qvgen_' robot '.' name]);
compiled = str2func(['qvgen_' robot '.fast']);
failures = differs(wanted, results(own, given, sizes), [name ' in Octave']);
failures += differs(wanted, results(@(varargin) compiled(name, varargin{:}), given, sizes), [name ', compiled']);
first = cellfun(@(x) x(:, 1:min(1, columns(x))), given, 'UniformOutput', false);
failures += differs(cellfun(@(x) x(1:rows_of(x, n))', wanted, 'UniformOutput', false), ...
                    cellfun(@(x) x(:), results(own, first, sizes), 'UniformOutput', false), [name ' of one column']);
if isscalar(rows), return; end
repeated = given;
repeated{1} = repmat(first{1}, 1, n);
given{1} = first{1};
failures += differs(results(own, repeated, sizes), results(own, given, sizes), [name ' with one first argument']);
end

function count = rows_of(x, n)
count = numel(x) / n;
end

function found = results(call, given, sizes)
found = cell(1, numel(sizes));
[found{:}] = call(given{:});
end

function failed = differs(a, b, what)
failed = ~all(cellfun(@same, a, b));
if failed, printf('%s differs\n', what); end
end

function yes = same(a, b)
yes = numel(a) == numel(b) && ndims(a) == ndims(b) && all(size(a) == size(b)) && ...
      all(typecast(a(:), 'uint64') == typecast(b(:), 'uint64') | (isnan(a(:)) & isnan(b(:))));
end
