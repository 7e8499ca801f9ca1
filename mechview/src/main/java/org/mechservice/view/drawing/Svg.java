package org.mechservice.view.drawing;

import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/**
 * Writes a picture as SVG 1.1. Colours are attributes, for readers that know no style sheets; a
 * style sheet changes them where the reader prefers dark pages.
 */
public final class Svg {
  private static final String FONT = "Helvetica,Arial,'Liberation Sans','DejaVu Sans',sans-serif";

  private final Canvas canvas;
  private final Theme theme;
  private final StringBuilder out = new StringBuilder();
  private final Set<Ink> filled = EnumSet.of(Ink.PAGE);
  private final Set<Ink> stroked = EnumSet.noneOf(Ink.class);

  private Svg(Canvas canvas, Theme theme) {
    this.canvas = canvas;
    this.theme = theme;
  }

  /** Returns the picture as a file of its own. */
  public static String of(Canvas canvas, Theme theme) {
    return new Svg(canvas, theme).text();
  }

  /** Returns a text with the characters of markup escaped, and control characters left out. */
  public static String escape(String text) {
    return text.replaceAll("[\\p{Cntrl}\uFFFE\uFFFF]", " ")
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  private String text() {
    canvas.marks().forEach(this::write);
    String content = out.toString();
    String size =
        "viewBox=\"0 0 "
            + number(canvas.width())
            + " "
            + number(canvas.height())
            + "\" width=\""
            + number(canvas.width())
            + "\" height=\""
            + number(canvas.height())
            + "\"";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        + size
        + " role=\"img\" aria-labelledby=\""
        + id("title", canvas.title())
        + " "
        + id("desc", canvas.description())
        + "\" font-family=\""
        + FONT
        + "\">\n<title id=\""
        + id("title", canvas.title())
        + "\">"
        + escape(canvas.title())
        + "</title>\n<desc id=\""
        + id("desc", canvas.description())
        + "\">"
        + escape(canvas.description())
        + "</desc>\n"
        + style()
        + "<rect width=\"100%\" height=\"100%\" "
        + fill(Ink.PAGE)
        + "/>\n"
        + content
        + "</svg>\n";
  }

  /**
   * Returns an identifier that follows from what it names: a page may hold several pictures, and
   * what has the same identifier in two of them is then the same.
   */
  private static String id(String kind, String text) {
    return kind + "-" + Integer.toHexString(text.hashCode());
  }

  private static String clipId(Mark.Clipped clip) {
    return id("clip", clip.x() + " " + clip.y() + " " + clip.width() + " " + clip.height());
  }

  private String style() {
    if (theme != Theme.AUTOMATIC) {
      return "";
    }
    StringBuilder css = new StringBuilder("<style>@media (prefers-color-scheme:dark){");
    for (Ink ink : filled) {
      css.append(".").append(styleName("fill", ink)).append("{fill:").append(ink.hex(Theme.DARK));
      css.append('}');
    }
    for (Ink ink : stroked) {
      css.append(".")
          .append(styleName("stroke", ink))
          .append("{stroke:")
          .append(ink.hex(Theme.DARK));
      css.append('}');
    }
    return css.append("}</style>\n").toString();
  }

  private static String styleName(String kind, Ink ink) {
    return kind + "-" + ink.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private String fill(Ink ink) {
    filled.add(ink);
    return "class=\"" + styleName("fill", ink) + "\" fill=\"" + ink.hex(theme) + "\"";
  }

  private String stroke(Ink ink) {
    stroked.add(ink);
    return "class=\"" + styleName("stroke", ink) + "\" stroke=\"" + ink.hex(theme) + "\"";
  }

  private void write(Mark mark) {
    if (mark instanceof Mark.Stroked line) {
      stroke(line);
    } else if (mark instanceof Mark.Filled area) {
      out.append("<path ").append(fill(area.ink()));
      if (area.opacity() < 1) {
        out.append(" fill-opacity=\"").append(number(area.opacity())).append('"');
      }
      out.append(" d=\"").append(path(area.shape())).append("\"/>\n");
    } else if (mark instanceof Mark.Written written) {
      text(written.label());
    } else if (mark instanceof Mark.Opened part) {
      out.append("<g><title>").append(escape(part.title())).append("</title>\n");
    } else if (mark instanceof Mark.Clipped clip) {
      String id = clipId(clip);
      out.append("<clipPath id=\"").append(id).append("\"><rect x=\"");
      out.append(number(clip.x())).append("\" y=\"").append(number(clip.y()));
      out.append("\" width=\"").append(number(clip.width())).append("\" height=\"");
      out.append(number(clip.height()))
          .append("\"/></clipPath>\n<g clip-path=\"url(#")
          .append(id)
          .append(")\">\n");
    } else {
      out.append("</g>\n");
    }
  }

  private void stroke(Mark.Stroked line) {
    Pen pen = line.pen();
    out.append("<path fill=\"none\" ").append(stroke(pen.ink()));
    out.append(" stroke-width=\"").append(number(pen.width())).append('"');
    if (pen.opacity() < 1) {
      out.append(" stroke-opacity=\"").append(number(pen.opacity())).append('"');
    }
    if (!pen.dash().isEmpty()) {
      out.append(" stroke-dasharray=\"");
      pen.dash().forEach(length -> out.append(number(length)).append(' '));
      out.setCharAt(out.length() - 1, '"');
    } else {
      out.append(" stroke-linecap=\"round\"");
    }
    out.append(" stroke-linejoin=\"round\" d=\"").append(path(line.shape())).append("\"/>\n");
  }

  private void text(Label label) {
    out.append("<text x=\"").append(number(label.x())).append("\" y=\"");
    out.append(number(label.y())).append("\" font-size=\"").append(number(label.size()));
    out.append("\" ").append(fill(label.ink()));
    if (label.anchor() != Label.Anchoring.START) {
      out.append(" text-anchor=\"");
      out.append(label.anchor().name().toLowerCase(Locale.ROOT)).append('"');
    }
    if (label.bold()) {
      out.append(" font-weight=\"bold\"");
    }
    if (label.upwards()) {
      out.append(" transform=\"rotate(-90 ").append(number(label.x())).append(' ');
      out.append(number(label.y())).append(")\"");
    }
    out.append('>').append(escape(label.text())).append("</text>\n");
  }

  private static String path(Shape shape) {
    StringBuilder d = new StringBuilder();
    double[] c = new double[6];
    for (PathIterator at = shape.getPathIterator(null); !at.isDone(); at.next()) {
      int numbers =
          switch (at.currentSegment(c)) {
            case PathIterator.SEG_MOVETO -> put(d, 'M', 2);
            case PathIterator.SEG_LINETO -> put(d, 'L', 2);
            case PathIterator.SEG_QUADTO -> put(d, 'Q', 4);
            case PathIterator.SEG_CUBICTO -> put(d, 'C', 6);
            default -> put(d, 'Z', 0);
          };
      for (int i = 0; i < numbers; i++) {
        d.append(i == 0 ? "" : " ").append(number(c[i]));
      }
    }
    return d.toString();
  }

  private static int put(StringBuilder d, char command, int numbers) {
    d.append(command);
    return numbers;
  }

  /** Returns a number with at most two decimals. */
  private static String number(double value) {
    long hundredths = Math.round(value * 100);
    String sign = hundredths < 0 ? "-" : "";
    long size = Math.abs(hundredths);
    String whole = sign + size / 100;
    long rest = size % 100;
    if (rest == 0) {
      return whole;
    }
    String decimals = rest % 10 == 0 ? "" + rest / 10 : (rest < 10 ? "0" : "") + rest;
    return whole + "." + decimals;
  }
}
