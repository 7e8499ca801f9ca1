package org.mechservice.benchmarks.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** A measurement of one property of the methods. */
public interface MethodStudy {
  /** Returns the study's name on the command line. */
  String name();

  /** Measures, and writes the findings to a page. */
  void measure(StudyPage page);

  /** Returns all studies, in the order of their reading. */
  static List<MethodStudy> all(StudyContext context) {
    return List.of(
        new GrowthStudy(context),
        new PeriodsStudy(context),
        new NoiseStudy(context),
        new DampingStudy(context),
        new SingularStudy(context),
        new StartStudy(context),
        new ConditionStudy(context),
        new NewtonStudy(context),
        new AutoStudy(context),
        new ServiceStudy(context));
  }

  /**
   * Measures and writes page and figures, {@code stability-NAME.html} and {@code .csv}.
   *
   * @throws IOException if they cannot be written
   */
  default Path write(Path folder, StudyContext context) throws IOException {
    context.at(name(), 0);
    StudyPage page = new StudyPage("stability-" + name());
    measure(page);
    if (context.quick()) {
      page.notes("Measured quickly: shorter runs and fewer points than a full measurement.");
    }
    return page.write(folder);
  }
}
