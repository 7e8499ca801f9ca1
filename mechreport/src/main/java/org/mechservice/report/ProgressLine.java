package org.mechservice.report;

import java.io.PrintWriter;
import java.util.Locale;
import org.mechservice.report.measure.ReportProgress;

/**
 * Progress of a report: one line that is overwritten on a terminal; elsewhere a line for every
 * tenth of the work.
 */
public final class ProgressLine implements ReportProgress, AutoCloseable {
  private static final boolean TERMINAL = Boolean.getBoolean("mech.terminal");
  private static final int WIDTH = 79;
  private static final int PARTS = 10;

  private final PrintWriter err;
  private int partShown = -1;
  private boolean shown;

  /**
   * @param err takes the lines
   */
  public ProgressLine(PrintWriter err) {
    this.err = err;
  }

  @Override
  public void at(String what, double done, double secondsLeft) {
    int part = (int) (PARTS * done);
    if (!TERMINAL && part == partShown) {
      return;
    }
    partShown = part;
    String left =
        Double.isNaN(secondsLeft)
            ? ""
            : String.format(Locale.ROOT, ", %.0f s left", Math.ceil(secondsLeft));
    String text = String.format(Locale.ROOT, "%3.0f %%  %s%s", 100 * done, what, left);
    if (TERMINAL) {
      err.print("\r" + fitted(text));
      err.flush();
      shown = true;
    } else {
      err.println(text);
    }
  }

  private static String fitted(String text) {
    String cut = text.length() > WIDTH ? text.substring(0, WIDTH) : text;
    return cut + " ".repeat(WIDTH - cut.length());
  }

  /** Erases the line. */
  @Override
  public void close() {
    if (shown) {
      err.print("\r" + " ".repeat(WIDTH) + "\r");
      err.flush();
      shown = false;
    }
  }
}
