package org.mechservice.sim.service;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.CheckReport;

/**
 * The check reports of the models that administrators looked at last, each computed once. Keeping
 * what was read of every run would take much memory. Thread-safe.
 */
final class CheckReports {
  private static final int KEPT = 32;

  private record Model(String fileName, String text) {}

  private final Map<Model, String> latest =
      new LinkedHashMap<>(KEPT, 0.75f, /* accessOrder= */ true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Model, String> eldest) {
          return size() > KEPT;
        }
      };

  /** Returns the check report of a run's model as JSON; empty if its text is not kept. */
  synchronized String of(RunIdentity run) {
    if (run.modelText().isEmpty()) {
      return "";
    }
    return latest.computeIfAbsent(
        new Model(run.fileName(), run.modelText()), CheckReports::computed);
  }

  private static String computed(Model model) {
    try {
      byte[] content = model.text().getBytes(StandardCharsets.UTF_8);
      return CheckReport.of(MechmlReader.read(model.fileName(), content)).json();
    } catch (MechmlException e) {
      return ""; // its encoding is not UTF-8
    }
  }
}
