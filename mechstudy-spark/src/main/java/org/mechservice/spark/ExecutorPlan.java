package org.mechservice.spark;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.study.run.StudyFiles;
import org.mechservice.study.run.StudyPlan;

/** The studies of an executor's process, each read and its model generated once. */
final class ExecutorPlan {
  private static final Map<String, StudyPlan> PLANS = new ConcurrentHashMap<>();

  private ExecutorPlan() {}

  /**
   * Returns the study; the first call of a process reads it.
   *
   * @throws IOException if it cannot be used here; says why
   */
  static StudyPlan of(StudyFiles files) throws IOException {
    StudyPlan known = PLANS.get(files.identity());
    return known != null ? known : read(files);
  }

  private static synchronized StudyPlan read(StudyFiles files) throws IOException {
    StudyPlan known = PLANS.get(files.identity());
    if (known == null) {
      Path folder = Files.createTempDirectory("mechstudy");
      try {
        known = files.read(folder);
      } catch (MechmlException e) {
        throw new IOException(e.getMessage(), e);
      } finally {
        delete(folder);
      }
      PLANS.put(files.identity(), known);
    }
    return known;
  }

  private static void delete(Path folder) throws IOException {
    List<File> all;
    try (Stream<Path> files = Files.walk(folder)) {
      all = files.sorted(Comparator.reverseOrder()).map(Path::toFile).toList();
    }
    all.forEach(File::delete);
  }
}
