// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace comparison {

/// Collects the fastest repetition of each benchmark "quantity/row/variant" and prints, for each quantity,
/// one table: rows by variants, in nanoseconds, with the ratio to the first variant behind each other one.
class Table : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  struct Row {
    std::string name;
    std::map<std::string, double> nanoseconds;
  };
  struct Quantity {
    std::string name;
    std::vector<std::string> variants;
    std::vector<Row> rows;
  };
  static void print(const Quantity& quantity);
  std::vector<Quantity> quantities_;
};

}  // namespace comparison
