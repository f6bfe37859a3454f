// SPDX-License-Identifier: MIT
// A model of MuJoCo from its text.
#pragma once

#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include <mujoco/mujoco.h>

namespace qvgen::test::loops {

using MujocoModel = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using MujocoData = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

/// Throws std::runtime_error with MuJoCo's words if it does not take the text.
inline MujocoModel mujoco_model(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "loops.xml", static_cast<int>(text.size())) != 0)
    throw std::runtime_error("MuJoCo: no memory for the model's text");
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "loops.xml")], text.data(), text.size());
  char error[1000] = "";
  MujocoModel model(mj_loadXML("loops.xml", files.get(), error, sizeof error), &mj_deleteModel);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

}  // namespace qvgen::test::loops
