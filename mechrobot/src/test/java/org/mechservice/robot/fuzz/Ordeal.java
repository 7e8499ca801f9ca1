package org.mechservice.robot.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.Severity;

/**
 * What files go through: each is read, or refused with messages fit to be seen; nothing else may
 * come of it, and not much memory may go into it.
 */
final class Ordeal {
  /** Makes a model of a file. */
  interface Reader {
    MechmlModel read(byte[] content) throws MechmlException;
  }

  /**
   * Most that reading a file may allocate: files here are below 100 kB, entities may blow an
   * attribute up to 100 000 characters, and each of its 600 000 elements at most costs a few
   * hundred bytes.
   */
  private static final long MOST_BYTES = 256L << 20;

  private static final Pattern CODE = Pattern.compile("M-\\d{3}");

  /** What only a programmer would understand. */
  private static final Pattern NOISE =
      Pattern.compile(
          "MSG_|\\bat org\\.|Exception|\\bnull\\b|java\\.(util|lang\\.[A-Z]\\w+Error)|[\n\r]");

  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private final Map<String, Integer> codes = new TreeMap<>();
  private int read;
  private int refused;
  private long mostBytes;
  private long slowest;

  /** Tries a file. */
  void with(byte[] content, Reader reader) {
    long bytes = threads.getCurrentThreadAllocatedBytes();
    long start = System.nanoTime();
    try {
      MechmlModel model = reader.read(content);
      read++;
      requireFiniteStart(model);
      requireFit(model.warnings());
    } catch (MechmlException e) {
      refused++;
      assertThat(e.diagnostics()).anyMatch(d -> d.severity() == Severity.ERROR);
      requireFit(e.diagnostics());
      e.diagnostics().stream().map(said -> said.code().code()).distinct().forEach(this::count);
    } catch (RuntimeException | Error e) {
      throw new AssertionError(new String(content, StandardCharsets.UTF_8), e);
    }
    slowest = Math.max(slowest, System.nanoTime() - start);
    mostBytes = Math.max(mostBytes, threads.getCurrentThreadAllocatedBytes() - bytes);
    assertThat(mostBytes).as("memory").isLessThan(MOST_BYTES);
  }

  private void count(String code) {
    codes.merge(code, 1, Integer::sum);
  }

  private static void requireFit(List<Diagnostic> said) {
    for (Diagnostic one : said) {
      if (!CODE.matcher(one.code().code()).matches()
          || one.message().isBlank()
          || NOISE.matcher(withoutQuotes(one.message())).find()) {
        throw new AssertionError("not fit to be seen: " + one);
      }
    }
  }

  /** What stands in quotes is the file's own. */
  private static String withoutQuotes(String message) {
    return message.replaceAll("\"[^\"]*\"", "");
  }

  private static void requireFiniteStart(MechmlModel model) {
    double[] y = new double[model.mechanism().positionCount() + model.mechanism().velocityCount()];
    model.mechanism().initialState(y);
    assertThat(y).doesNotContain(Double.NaN).doesNotContain(Double.POSITIVE_INFINITY);
  }

  int read() {
    return read;
  }

  int refused() {
    return refused;
  }

  /** Returns how many files each message was about. */
  Map<String, Integer> codes() {
    return codes;
  }

  /** Returns the most that a file made the reader allocate, MB. */
  double mostMegabytes() {
    return mostBytes / 1048576.0;
  }

  /** Returns the longest time that a file took, s. */
  double slowest() {
    return slowest * 1e-9;
  }
}
