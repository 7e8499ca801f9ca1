package org.mechservice.view.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.imageio.ImageIO;
import org.mechservice.solver.catalogue.MessageCode;

/** Writes a picture as PNG, two image points for each px, without a screen. */
public final class Png {
  private static final int SCALE = 2;

  private final Graphics2D graphics;
  private final Theme theme;
  private final Deque<Shape> clips = new ArrayDeque<>();

  private Png(Graphics2D graphics, Theme theme) {
    this.graphics = graphics;
    this.theme = theme;
  }

  /**
   * Returns the picture as the bytes of a PNG file.
   *
   * @throws IOException S-042 if Java cannot write texts here, because there are no fonts
   */
  public static byte[] of(Canvas canvas, Theme theme) throws IOException {
    System.setProperty("java.awt.headless", "true");
    BufferedImage image =
        new BufferedImage(
            (int) Math.ceil(SCALE * canvas.width()),
            (int) Math.ceil(SCALE * canvas.height()),
            BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    try {
      graphics.setColor(colour(Ink.PAGE, theme, 1));
      graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
      graphics.scale(SCALE, SCALE);
      graphics.setClip(new Rectangle2D.Double(0, 0, canvas.width(), canvas.height()));
      graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      graphics.setRenderingHint(
          RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
      graphics.setRenderingHint(
          RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
      graphics.setRenderingHint(
          RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
      Png png = new Png(graphics, theme);
      canvas.marks().forEach(png::write);
    } catch (LinkageError | IllegalStateException | NullPointerException e) {
      // The JDK's ways to say that the system has no font configuration.
      throw new IOException(
          MessageCode.FILE_UNUSABLE
              + " no PNG picture can be made: Java finds no fonts on this machine. Install"
              + " fontconfig with a font, such as fonts-dejavu, or write an SVG picture",
          e);
    } finally {
      graphics.dispose();
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, "png", bytes);
    return bytes.toByteArray();
  }

  private static Color colour(Ink ink, Theme theme, double opacity) {
    Color colour = Color.decode(ink.hex(theme));
    return new Color(
        colour.getRed(), colour.getGreen(), colour.getBlue(), (int) Math.round(255 * opacity));
  }

  private void write(Mark mark) {
    if (mark instanceof Mark.Stroked line) {
      graphics.setColor(colour(line.pen().ink(), theme, line.pen().opacity()));
      graphics.setStroke(stroke(line.pen()));
      graphics.draw(line.shape());
    } else if (mark instanceof Mark.Filled area) {
      graphics.setColor(colour(area.ink(), theme, area.opacity()));
      graphics.fill(area.shape());
    } else if (mark instanceof Mark.Written written) {
      text(written.label());
    } else if (mark instanceof Mark.Clipped clip) {
      clips.push(graphics.getClip());
      graphics.clip(new Rectangle2D.Double(clip.x(), clip.y(), clip.width(), clip.height()));
    } else if (mark instanceof Mark.Opened) {
      clips.push(graphics.getClip());
    } else {
      graphics.setClip(clips.pop());
    }
  }

  private static BasicStroke stroke(Pen pen) {
    if (pen.dash().isEmpty()) {
      return new BasicStroke((float) pen.width(), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }
    float[] dash = new float[pen.dash().size()];
    for (int i = 0; i < dash.length; i++) {
      dash[i] = (float) (double) pen.dash().get(i);
    }
    return new BasicStroke(
        (float) pen.width(), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dash, 0);
  }

  private void text(Label label) {
    graphics.setColor(colour(label.ink(), theme, 1));
    Font font =
        new Font(Font.SANS_SERIF, label.bold() ? Font.BOLD : Font.PLAIN, 1)
            .deriveFont((float) label.size());
    double width = font.getStringBounds(label.text(), graphics.getFontRenderContext()).getWidth();
    double estimate = label.box().getWidth();
    if (!label.upwards() && width > estimate) {
      font = font.deriveFont((float) (label.size() * estimate / width));
      width = estimate;
    }
    double before =
        switch (label.anchor()) {
          case START -> 0;
          case MIDDLE -> width / 2;
          case END -> width;
        };
    graphics.setFont(font);
    AffineTransform straight = graphics.getTransform();
    graphics.translate(label.x(), label.y());
    if (label.upwards()) {
      graphics.rotate(-Math.PI / 2);
    }
    graphics.drawString(label.text(), (float) -before, 0);
    graphics.setTransform(straight);
  }
}
