package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.admin.web.Chromium;

/**
 * Pictures of the player are those that were looked at when they were put here; {@code
 * -Dgolden.write=true} takes them anew.
 *
 * <p>Both pictures are compared in cells of 8 by 8 pixels. The edge of a body goes through a cell
 * over 8 pixels or so, and graphics drivers may smooth each of them differently by half of the
 * contrast, which is 8 · 0.5/64 of it: below 16 of 255. A body that is somewhere else, or has
 * another colour, changes whole cells by several times as much, which the last test shows.
 */
@Tag("slow")
class PlayerPicturesTest {
  private static final Path GOLDEN = Path.of("src/test/resources/pictures");
  private static final int WIDTH = 320;
  private static final int HEIGHT = 200;
  private static final int CELL = 8;

  /** Most by which a colour of a cell may differ, of 255. */
  private static final double MOST = 16;

  @RegisterExtension static final InstalledBrowser BROWSER = new InstalledBrowser();

  @TempDir Path folder;

  private BufferedImage take(String model, double time, boolean dark, List<String> show)
      throws Exception {
    Chromium browser = BROWSER.get();
    browser.look(WIDTH, 400, dark);
    browser.open(PlayerInBrowserTest.view(Path.of("..", "examples", model + ".xml"), folder));
    browser.evaluate(
        "mechPlayer.prepare(" + WIDTH + "," + HEIGHT + ",'iso'," + new Gson().toJson(show) + ")");
    return still(browser, time);
  }

  private static BufferedImage still(Chromium browser, double time) throws Exception {
    browser.evaluate("mechPlayer.aim(" + time + ")");
    String url =
        browser
            .evaluate("mechPlayer.still(" + time + "," + WIDTH + "," + HEIGHT + ")")
            .getAsString();
    byte[] png = Base64.getDecoder().decode(url.substring(url.indexOf(',') + 1));
    return ImageIO.read(new ByteArrayInputStream(png));
  }

  /** Returns the largest difference of one colour of one cell, of 255. */
  private static double difference(BufferedImage one, BufferedImage other) {
    double largest = 0;
    for (int x = 0; x < WIDTH; x += CELL) {
      for (int y = 0; y < HEIGHT; y += CELL) {
        for (int shift = 0; shift <= 16; shift += 8) {
          largest = Math.max(largest, Math.abs(mean(one, x, y, shift) - mean(other, x, y, shift)));
        }
      }
    }
    return largest;
  }

  private static double mean(BufferedImage image, int left, int top, int shift) {
    double sum = 0;
    for (int x = 0; x < CELL; x++) {
      for (int y = 0; y < CELL; y++) {
        sum += image.getRGB(left + x, top + y) >> shift & 0xff;
      }
    }
    return sum / (CELL * CELL);
  }

  @CsvSource({
    "pendulum/pendulum, 0.9, false, reactions",
    "gearbox/gearbox, 0.1, true,",
    "elements/pathForce, 0.3, false,",
    "half-car/half-car, 1, false,",
    "crane/crane, 2, true, traces",
    "how-to/thrown-ball, 0.735, false, forces",
  })
  @ParameterizedTest
  void pictureIsTheOneThatWasLookedAt(String model, double time, boolean dark, String show)
      throws Exception {
    BufferedImage taken = take(model, time, dark, show == null ? List.of() : List.of(show));
    Path golden = GOLDEN.resolve(model.replaceFirst(".*/", "") + ".png");
    if (Boolean.getBoolean("golden.write")) {
      Files.createDirectories(GOLDEN);
      ImageIO.write(taken, "png", golden.toFile());
    }
    assertThat(difference(taken, ImageIO.read(golden.toFile()))).as(model).isLessThan(MOST);
  }

  @Test
  void aMechanismThatHasMovedIsAnotherPicture() throws Exception {
    BufferedImage taken = take("gearbox/gearbox", 0.1, true, List.of());
    BufferedImage later = still(BROWSER.get(), 0.104);
    assertThat(difference(taken, later)).isGreaterThan(2 * MOST);
  }
}
