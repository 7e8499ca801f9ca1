package org.mechservice.view.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.result.ResultComparison;
import org.mechservice.result.SignalTable;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.Theme;
import org.mechservice.view.plot.DifferencePlot;
import org.mechservice.view.plot.Plot;
import org.mechservice.view.plot.PlotPicture;

/** The differences between two runs, in words and as a picture, for the page. */
final class Differences {
  /** The tolerance that {@code mech compare} has by itself, relative to the size of a signal. */
  private static final double TOLERANCE = 1e-3;

  private Differences() {}

  /**
   * Compares two runs.
   *
   * @param names of the runs
   * @throws RefusedRequestException if they have no signal in common
   */
  static JsonObject of(List<String> names, SignalTable first, SignalTable second) {
    ResultComparison comparison =
        ResultComparison.of(first, second, TOLERANCE, OptionalDouble.empty());
    JsonObject answer = new JsonObject();
    try {
      Plot plot = DifferencePlot.of(names, first, second, comparison);
      answer.addProperty("title", plot.title());
      JsonArray notes = new JsonArray();
      plot.notes().forEach(notes::add);
      answer.add("notes", notes);
      answer.addProperty("picture", Svg.of(PlotPicture.draw(plot), Theme.AUTOMATIC));
    } catch (IllegalArgumentException e) {
      throw new RefusedRequestException(400, String.valueOf(e.getMessage()));
    }
    answer.addProperty("equal", comparison.isEqual());
    answer.addProperty("tolerance", TOLERANCE);
    return answer;
  }
}
