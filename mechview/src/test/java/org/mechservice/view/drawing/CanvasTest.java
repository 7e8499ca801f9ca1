package org.mechservice.view.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.mechservice.view.drawing.Label.Anchoring;

/** One picture becomes the same SVG and PNG, with names and in light and dark. */
class CanvasTest {
  private static Canvas canvas() {
    Canvas canvas = new Canvas(100, 50, "A <line>", "It rises & falls.");
    canvas.part("slope", () -> canvas.draw(new Line2D.Double(0, 50, 100, 0), pen()));
    canvas.write(new Label(50, 25, "\"q\" < 1", 10, Anchoring.MIDDLE, Ink.TEXT));
    return canvas;
  }

  private static Pen pen() {
    return new Pen(Ink.CURVE_0, 4);
  }

  @Test
  void readersThatCannotSeeThePictureAreToldWhatItShows() throws Exception {
    SvgPicture svg = SvgPicture.read(Svg.of(canvas(), Theme.AUTOMATIC));

    assertThat(svg.parts()).containsExactly("A <line>", "slope");
    assertThat(svg.document().getElementsByTagName("desc").item(0).getTextContent())
        .isEqualTo("It rises & falls.");
    assertThat(svg.texts()).containsExactly("\"q\" < 1");
    assertThat(svg.document().getDocumentElement().getAttribute("role")).isEqualTo("img");
  }

  @Test
  void fileFollowsItsReaderUnlessAThemeIsDemanded() {
    assertThat(Svg.of(canvas(), Theme.AUTOMATIC))
        .contains("prefers-color-scheme:dark", Ink.PAGE.hex(Theme.LIGHT));
    assertThat(Svg.of(canvas(), Theme.DARK))
        .contains(Ink.PAGE.hex(Theme.DARK))
        .doesNotContain("prefers-color-scheme");
  }

  @Test
  void pngHasTwoPointsForEachPixelAndTheColoursOfItsTheme() throws Exception {
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(Png.of(canvas(), Theme.DARK)));

    assertThat(image.getWidth()).isEqualTo(200);
    assertThat(image.getRGB(2, 2) & 0xFFFFFF).isEqualTo(Integer.decode(Ink.PAGE.hex(Theme.DARK)));
    assertThat(image.getRGB(20, 90) & 0xFFFFFF)
        .isEqualTo(Integer.decode(Ink.CURVE_0.hex(Theme.DARK)));
  }

  @Test
  void coloursOfTextHaveTheContrastThatTheAccessibilityGuidelinesAsk() {
    for (Theme theme : new Theme[] {Theme.LIGHT, Theme.DARK}) {
      for (Ink ink : Ink.values()) {
        boolean written = ink.name().startsWith("CURVE") || ink == Ink.TEXT || ink == Ink.MUTED;
        if (written) {
          assertThat(contrast(ink.hex(theme), Ink.PAGE.hex(theme)))
              .as(ink + " " + theme)
              .isGreaterThanOrEqualTo(4.5);
        }
      }
    }
  }

  /** Contrast of two colours, WCAG 2.2. */
  private static double contrast(String one, String other) {
    double a = luminance(Integer.decode(one));
    double b = luminance(Integer.decode(other));
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  }

  private static double luminance(int rgb) {
    return 0.2126 * linear(rgb >> 16) + 0.7152 * linear(rgb >> 8) + 0.0722 * linear(rgb);
  }

  private static double linear(int component) {
    double c = (component & 255) / 255.0;
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  }

  @Test
  void textsFindPlacesWhereNothingIs() {
    FreePlaces places = new FreePlaces(new Rectangle2D.Double(0, 0, 100, 100));
    Label first = new Label(10, 20, "bar", 10, Anchoring.START, Ink.TEXT);
    Label beside = new Label(10, 60, "bar", 10, Anchoring.START, Ink.TEXT);
    Label outside = new Label(95, 20, "bar", 10, Anchoring.START, Ink.TEXT);

    assertThat(places.take(List.of(outside, first))).contains(first);
    assertThat(places.take(List.of(first, beside))).contains(beside);
    assertThat(places.take(List.of(first, beside))).isEmpty();
  }

  @Test
  void textsRatherCrossNoLine() {
    FreePlaces places = new FreePlaces(new Rectangle2D.Double(0, 0, 100, 100));
    places.avoid(new Line2D.Double(0, 18, 100, 18));
    Label crossed = new Label(10, 20, "bar", 10, Anchoring.START, Ink.TEXT);
    Label clear = new Label(10, 60, "bar", 10, Anchoring.START, Ink.TEXT);

    assertThat(places.take(List.of(crossed, clear))).contains(clear);
    assertThat(places.take(List.of(crossed))).contains(crossed);
  }
}
