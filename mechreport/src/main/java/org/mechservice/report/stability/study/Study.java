package org.mechservice.report.stability.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** One property measured. */
public interface Study {
  /** Returns the study's name on the command line. */
  String name();

  /** Measures, and says what it found. */
  void measure(StudyPage page);

  /** Returns all studies, in the order of their reading. */
  static List<Study> all(Bench bench) {
    return List.of(
        new GrowthStudy(bench),
        new PeriodsStudy(bench),
        new NoiseStudy(bench),
        new DampingStudy(bench),
        new SingularStudy(bench),
        new StartStudy(bench),
        new ConditionStudy(bench),
        new NewtonStudy(bench),
        new AutoStudy(bench),
        new ServiceStudy(bench));
  }

  /**
   * Measures and writes page and figures, {@code stability-NAME.html} and {@code .csv}.
   *
   * @throws IOException if they cannot be written
   */
  default Path write(Path folder, Bench bench) throws IOException {
    bench.at(name(), 0);
    StudyPage page = new StudyPage("stability-" + name());
    measure(page);
    if (bench.quick()) {
      page.notes("Measured quickly: shorter runs and fewer points than a full measurement.");
    }
    return page.write(folder);
  }
}
