package org.mechservice.cli.picture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Png;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.Theme;
import org.mechservice.view.plot.Plot;
import org.mechservice.view.plot.PlotPage;
import org.mechservice.view.plot.PlotPicture;

/** Writes a picture in the format that the ending of the file name tells. */
final class PictureFile {
  static final String SVG = "svg";
  static final String PNG = "png";
  static final String HTML = "html";

  /** The formats of diagrams. */
  private static final List<String> OF_DIAGRAMS = List.of(SVG, PNG, HTML);

  private PictureFile() {}

  /**
   * Returns the ending of a file name, before anything is computed for it.
   *
   * @throws UsageException if it is none of the formats, or the file cannot be written
   */
  static String format(Path target, List<String> formats) {
    String name = String.valueOf(target.getFileName());
    String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    if (!name.contains(".") || !formats.contains(ending)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --output "
              + target
              + ": the name ends in none of ."
              + String.join(", .", formats));
    }
    OutputFile.requireUsable(target);
    return ending;
  }

  /**
   * Returns the format of a diagram's file, before anything is computed for it.
   *
   * @throws UsageException if the ending is none of svg, png and html, or the file cannot be
   *     written
   */
  static String formatOfDiagram(Path target) {
    return format(target, OF_DIAGRAMS);
  }

  /** Writes a diagram as SVG, PNG or page. */
  static void write(Path target, String format, Plot plot, boolean dark) throws IOException {
    if (format.equals(HTML)) {
      String page = PlotPage.of(plot, dark ? Theme.DARK : Theme.AUTOMATIC);
      OutputFile.write(target, page.getBytes(StandardCharsets.UTF_8));
    } else {
      write(target, format, PlotPicture.draw(plot), dark);
    }
  }

  /** Writes an SVG or PNG file. */
  static void write(Path target, String format, Canvas canvas, boolean dark) throws IOException {
    if (format.equals(PNG)) {
      OutputFile.write(target, Png.of(canvas, dark ? Theme.DARK : Theme.LIGHT));
    } else {
      String text = Svg.of(canvas, dark ? Theme.DARK : Theme.AUTOMATIC);
      OutputFile.write(target, text.getBytes(StandardCharsets.UTF_8));
    }
  }
}
