// SPDX-License-Identifier: MIT
// The export dialog and the progress of a running export.
#pragma once
#include <optional>
#include <string>

#include "editor/ui/still_job.hpp"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

class ExportDialog {
 public:
  /// Shows the dialog from the next draw() on, with the project's size and a name beside the project.
  void open(const Scene& scene, const std::filesystem::path& project);
  void setPath(const std::filesystem::path& path);
  /// Relative RMSE that a picture is to reach: as chosen here, else 1 %.
  double errorTarget() const { return settings_.byError ? 0.01 * settings_.errorPercent : 0.01; }

  struct Answer {
    bool browse = false;  // the person wants to choose the file; the dialog waits for setPath()
    std::optional<StillSettings> start;
  };
  Answer draw(Ui& ui);

 private:
  void drawFields(Ui& ui, Answer& answer);
  std::string problem() const;

  StillSettings settings_;
  std::string pathText_;
  bool opening_ = false, confirmOverwrite_ = false;
};

enum class JobWish { goOn, cancel, keepPartial };
/// A small window over the viewport while `job` runs.
JobWish drawJob(Ui& ui, const StillJob& job, ImVec2 bottomRight);

}  // namespace steradian::ui
