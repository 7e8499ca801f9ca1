package org.mechservice.view.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.SvgPicture;
import org.mechservice.view.drawing.Theme;

/** Diagrams show what the result files say. */
class PlotTest {
  @TempDir private Path folder;

  private Path file(String name, String header, int rows, IntFunction<String> row)
      throws IOException {
    StringBuilder text = new StringBuilder(header).append("\r\n");
    for (int i = 0; i < rows; i++) {
      text.append(row.apply(i)).append("\r\n");
    }
    return Files.writeString(folder.resolve(name), text);
  }

  private static Plot read(Path file, String... columns) throws IOException {
    return new PlotRequest(List.of(file), List.of(columns), Optional.empty()).read();
  }

  /** Pictures stand beside each other on pages; a clip of one must not cut another one off. */
  @Test
  void differentPicturesShareNoIdentifier() throws IOException {
    String narrow =
        Svg.of(PlotPicture.draw(read(file("a.csv", "t,x", 9, i -> i + "," + i))), Theme.LIGHT);
    String wide =
        Svg.of(
            PlotPicture.draw(read(file("b.csv", "t,a longer name", 9, i -> i + "," + 1e9 * i))),
            Theme.LIGHT);
    Pattern id = Pattern.compile(" id=\"([^\"]*)\"");
    assertThat(id.matcher(narrow).results().map(found -> found.group(1)))
        .hasSizeGreaterThan(2)
        .doesNotContainAnyElementsOf(
            id.matcher(wide).results().map(found -> found.group(1)).toList());
  }

  private static SvgPicture picture(Plot plot) throws Exception {
    return SvgPicture.read(Svg.of(PlotPicture.draw(plot), Theme.AUTOMATIC));
  }

  private static List<String> names(Plot plot) {
    return plot.panels().stream()
        .flatMap(panel -> panel.curves().stream())
        .map(Plot.Curve::name)
        .toList();
  }

  /** Joint positions and velocities, an Euler parameter and a force. */
  private Path result() throws IOException {
    Path file =
        file(
            "r.csv",
            "t,j1.q,j2.q,free.q[0],j1.v,j2.v,spring.tension",
            50,
            i -> i * 0.1 + "," + i + "," + -i + ",1," + 2 * i + ",3,1e6");
    Files.writeString(
        folder.resolve("r.units.json"),
        "{\"t\":\"s\",\"j1.q\":\"rad\",\"j2.q\":\"m\",\"free.q[0]\":\"1\",\"j1.v\":\"rad/s\","
            + "\"j2.v\":\"m/s\",\"spring.tension\":\"N\"}");
    return file;
  }

  @Test
  void positionsOfTheJointsAreDrawnByThemselvesOnePanelAUnit() throws Exception {
    Plot plot = read(result());

    assertThat(names(plot)).containsExactly("j1.q", "j2.q");
    assertThat(plot.panels()).extracting(Plot.Panel::unit).containsExactly("rad", "m");
    assertThat(plot.notes()).hasSize(1).first().asString().contains("2 of 6", "free.q[0]");
    assertThat(picture(plot).texts()).contains("q (rad)", "q (m)", "t (s)", "j1.q", "j2.q");
    assertThat(picture(plot).illegible()).isEmpty();
  }

  @Test
  void wildcardsChooseColumnsAndBracketsAreLetters() throws Exception {
    assertThat(names(read(result(), "j?.v"))).containsExactly("j1.v", "j2.v");
    assertThat(names(read(result(), "free.q[?]", "*.tension")))
        .containsExactly("free.q[0]", "spring.tension");
  }

  @Test
  void unknownColumnIsRefusedWithTheNearestNames() {
    assertThatThrownBy(() -> read(result(), "j2.w"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("S-041")
        .hasMessageContaining("\"j2.w\"")
        .hasMessageContaining("\"j2.q\", \"j2.v\"");
    assertThatThrownBy(() -> read(result(), "nothing*")).hasMessageContaining("nothing*");
  }

  @Test
  void longFileKeepsItsPeaks() throws Exception {
    int rows = 100_000;
    Path file =
        file(
            "long.csv",
            "t,a.q,b.q",
            rows,
            i -> i * 1e-3 + "," + (i == 77_777 ? 9.5 : Math.sin(i)) + "," + (i == 31 ? -40 : 0));
    Plot plot = read(file);

    List<double[]> table = plot.panels().get(0).curves().get(0).table();
    assertThat(table.size()).isLessThan(30_000);
    assertThat(table.get(0)[0]).isZero();
    assertThat(table.get(table.size() - 1)[0]).isEqualTo((rows - 1) * 1e-3);
    assertThat(table).anyMatch(row -> row[1] == 9.5 && row[0] == 77_777 * 1e-3);
    assertThat(table).anyMatch(row -> row[2] == -40 && row[0] == 31 * 1e-3);
    String svg = Svg.of(PlotPicture.draw(plot), Theme.LIGHT);
    assertThat(svg.length()).isLessThan(400_000);
    assertThat(PlotPicture.description(plot)).contains("from -40.00 to 9.500");
  }

  @Test
  void emptyCellsAndWhatIsNotFiniteAreGaps() throws Exception {
    Path file =
        file(
            "gaps.csv",
            "t,a",
            9,
            i -> i + "," + (i == 3 ? "" : i == 4 ? "NaN" : i == 6 ? "-Infinity" : "" + i));
    Plot plot = read(file);

    assertThat(picture(plot).illegible()).isEmpty();
    String svg = Svg.of(PlotPicture.draw(plot), Theme.LIGHT);
    String curve = svg.substring(svg.indexOf("<title>a</title>"));
    String path = curve.substring(curve.indexOf(" d=\"") + 4).split("\"", 2)[0];
    // Lines join rows 0 to 2, and 7 and 8; row 5 stands alone and is a dot.
    assertThat(path.chars().filter(c -> c == 'M').count()).isEqualTo(2);
    assertThat(curve).containsPattern("<path class=\"fill-[a-z0-9-]+\"");
  }

  @Test
  void gapSurvivesThinning() throws Exception {
    Path file = file("hole.csv", "t,a", 20_000, i -> i + "," + (i == 9_999 ? "" : i % 7));

    assertThat(read(file).panels().get(0).curves().get(0).table())
        .anyMatch(row -> row[0] == 9_999 && Double.isNaN(row[1]));
  }

  @Test
  void runsShareTheColourOfAColumnAndTheLegendNamesThem() throws Exception {
    Path one = file("one.csv", "t,a,b", 5, i -> i + "," + i + ",1");
    Path other = file("other.csv", "t,a", 7, i -> i + "," + 2 * i);
    Plot plot = new PlotRequest(List.of(one, other), List.of(), Optional.empty()).read();
    SvgPicture picture = picture(plot);

    assertThat(picture.texts()).contains("one.csv", "other.csv", "a", "b");
    assertThat(picture.parts()).contains("a, one.csv", "a, other.csv", "b, one.csv");
    assertThat(plot.notes()).anyMatch(note -> note.contains("other.csv has no column b"));
    assertThat(plot.panels().get(0).curves())
        .filteredOn(curve -> curve.name().equals("a"))
        .extracting(Plot.Curve::colour)
        .containsExactly(0, 0);
  }

  @Test
  void runsOfEqualNameAreToldApartByTheirFolders() throws Exception {
    Files.createDirectories(folder.resolve("stiff"));
    Path one = file("r.csv", "t,a", 2, i -> i + ",1");
    Path other = file("stiff/r.csv", "t,a", 2, i -> i + ",2");

    assertThat(new PlotRequest(List.of(one, other), List.of(), Optional.empty()).read().runs())
        .doesNotHaveDuplicates()
        .anyMatch(name -> name.endsWith(Path.of("stiff", "r.csv").toString()));
  }

  @Test
  void phasePlotHasAColumnOnItsHorizontalAxis() throws Exception {
    Plot plot = new PlotRequest(List.of(result()), List.of("j1.v"), Optional.of("j1.q")).read();

    assertThat(picture(plot).texts()).contains("j1.q (rad)", "v (rad/s)");
    assertThatThrownBy(
            () -> new PlotRequest(List.of(result()), List.of(), Optional.of("j1q")).read())
        .hasMessageContaining("\"j1.q\"");
  }

  @Test
  void textsStayLegibleWhateverTheNamesAndNumbers() throws Exception {
    String longName = "a_very_long_name_of_a_body_in_a_very_large_mechanism_of_many.q";
    Path file =
        file(
            "extreme.csv",
            "t,<script>.q," + longName + ",huge.q,tiny.q,constant.q,late.q,\"a,b.q\"",
            30,
            i ->
                1e5 * i
                    + ","
                    + i
                    + ",1e-9,"
                    + i * 5e307 / 15
                    + ","
                    + i * 1e-318
                    + ",-3,"
                    + (1e6 + i * 1e-6)
                    + ",0");
    Files.writeString(
        folder.resolve("extreme.units.json"),
        "{\"<script>.q\":\"a\",\""
            + longName
            + "\":\"b\",\"huge.q\":\"N\",\"tiny.q\":\"m\",\"constant.q\":\"J\",\"late.q\":\"s\"}");

    SvgPicture picture = picture(read(file));

    assertThat(picture.illegible()).isEmpty();
    assertThat(picture.texts()).contains("<script>.q", "a,b.q");
  }

  @Test
  void manyCurvesAreThinnedOutAndSaidSo() throws Exception {
    StringBuilder header = new StringBuilder("t");
    StringBuilder row = new StringBuilder();
    for (int i = 0; i < 200; i++) {
      header.append(",joint").append(i).append(".q");
      row.append(",").append(i);
    }
    Path file = file("many.csv", header.toString(), 3, i -> i + row.toString());

    Plot few = read(file);
    assertThat(names(few)).hasSize(16);
    assertThat(few.notes()).anyMatch(note -> note.contains("16 of 200"));
    Plot all = read(file, "*");
    assertThat(names(all)).hasSize(64);
    assertThat(all.notes()).anyMatch(note -> note.contains("first 64 of 200"));
    assertThat(picture(all).illegible()).isEmpty();
  }

  @Test
  void brokenFilesAreRefusedWithTheirLine() throws Exception {
    Path ragged = file("ragged.csv", "t,a", 3, i -> i == 1 ? "1" : "0,1");
    Path words = file("words.csv", "t,a", 2, i -> "0,high");
    Path empty = Files.writeString(folder.resolve("empty.csv"), "");
    Path image = Files.write(folder.resolve("image.csv"), new byte[] {'t', '\n', (byte) 0xFF});

    assertThatThrownBy(() -> read(ragged)).hasMessageContaining("line 3 has 1 values");
    assertThatThrownBy(() -> read(words)).hasMessageContaining("line 2, column \"a\": \"high\"");
    assertThatThrownBy(() -> read(empty))
        .hasMessageContaining("S-042")
        .hasMessageContaining("empty");
    assertThatThrownBy(() -> read(image)).hasMessageContaining("UTF-8");
    Files.writeString(folder.resolve("words.units.json"), "[1");
    assertThatThrownBy(() -> read(words)).hasMessageContaining("words.units.json");
  }

  @Test
  void fileWithoutRowsGivesEmptyAxes() throws Exception {
    Plot plot = read(file("none.csv", "t,a", 0, i -> ""));

    assertThat(picture(plot).illegible()).isEmpty();
    assertThat(plot.notes()).anyMatch(note -> note.contains("no rows"));
  }

  @Test
  void pageContainsAllItNeedsAndAllowsOnlyItsOwnScripts() throws Exception {
    Path file = file("</script>.csv".replace("/", "_"), "t,</script><b>", 4, i -> i + "," + i);
    String page = PlotPage.of(read(file), Theme.AUTOMATIC);

    assertThat(page).doesNotContain("src=", "<b>", "@import", "<link");
    String policy = page.split("Content-Security-Policy\" content=\"", 2)[1].split("\"", 2)[0];
    assertThat(policy).startsWith("default-src 'none'");
    List<MatchResult> scripts =
        Pattern.compile("(?s)<script>(.*?)</script>").matcher(page).results().toList();
    assertThat(scripts).hasSize(2);
    for (MatchResult script : scripts) {
      byte[] sha =
          MessageDigest.getInstance("SHA-256")
              .digest(script.group(1).getBytes(StandardCharsets.UTF_8));
      assertThat(policy).contains("'sha256-" + Base64.getEncoder().encodeToString(sha) + "'");
    }
    assertThat(page.toLowerCase(Locale.ROOT)).contains("<html lang=\"en\">", "<noscript>");
  }
}
