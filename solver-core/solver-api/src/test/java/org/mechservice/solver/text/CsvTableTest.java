package org.mechservice.solver.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Numbers of a CSV file are those that its writer meant, or the file is refused. */
class CsvTableTest {
  @TempDir private Path folder = Path.of("");

  private static CsvTable read(String text) throws IOException {
    return CsvTable.of(
        Path.of("t.csv"),
        text.replace('|', '\n').getBytes(StandardCharsets.UTF_8),
        StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '!',
      value = {
        "0;0,5|1;1,25! 1.25",
        "0,5;1|1;2,75! 2.75",
        "t;h|0;0,5|1;1,25! 1.25",
        "0,0.5|1,1.25! 1.25",
        "0;0.5|1;1.25! 1.25",
        "0\t0,5|1\t-1,25e-3! -1.25e-3",
        "^a,b^,h|1,2|3,4! 4",
        "0;0,5|# made by hand||1;1,25|! 1.25",
        "0;1|2;3! 3",
        "0;,5|1;,25! .25",
      })
  void delimiterAndDecimalMarkAreFoundOnceForTheFile(String text, String last) throws IOException {
    CsvTable table = read(text.replace('^', '"'));
    assertThat(table.number(table.size() - 1, 1)).isEqualTo(last);
    assertThat(table.width()).isEqualTo(2);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '!',
      value = {
        "0;0,5|1;1.25! decimal comma and others with a point",
        "0,1|1,2,3! the row \"1,2,3\" has 3 cells between commas, and the first row has 2",
        "t;h|0;1|2! the row \"2\" has 1 cells between semicolons",
        "0|1! its rows have one cell",
        "|# nothing! it has no rows",
      })
  void whatFitsNoRuleIsRefused(String text, String why) {
    assertThatThrownBy(() -> read(text)).hasMessageContaining(why);
  }

  @Test
  void cellThatIsNoNumberIsNamedWithTheMarksOfTheFile() throws IOException {
    CsvTable table = read("t;h|0;0,5|1;x");
    assertThatThrownBy(() -> table.number(2, 1))
        .hasMessageContaining("no number in column 2")
        .hasMessageContaining("cells between semicolons, decimals with a comma");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '!',
      value = {
        "0;0,5|1;1,5! cells between semicolons, decimals with a comma",
        "0;0.5|1;1.5! cells between semicolons, decimals with a point",
        "0,0.5|1,1.5! cells between commas, decimals with a point",
        "0~0,5|1~1,5! cells between tabs, decimals with a comma",
      })
  void layoutIsStated(String text, String layout) throws IOException {
    assertThat(read(text.replace('~', '\t')).layout()).isEqualTo(layout);
  }

  /** The model and its columns in two encodings: names are compared as texts, not as bytes. */
  @ParameterizedTest
  @CsvSource({"UTF-8, UTF-8", "ISO-8859-1, UTF-8", "ISO-8859-1, ISO-8859-1", "windows-1252, UTF-8"})
  void columnsAreFoundInTheEncodingThatTheModelDeclares(String ofModel, String ofTable)
      throws IOException {
    Path model = folder.resolve("m.xml");
    String text =
        "<?xml version=\"1.0\" encoding=\""
            + ofModel
            + "\"?><MechML><table name='r' file='h\u00f6he.csv' xColumn='Zeit' yColumn='H\u00f6he'/></MechML>";
    byte[] bytes = text.getBytes(Charset.forName(ofModel));
    Files.write(
        folder.resolve("h\u00f6he.csv"),
        "Zeit;H\u00f6he\n0;0,5\n1;2,75\n".getBytes(Charset.forName(ofTable)));
    String filled = new String(ModelFiles.inlined(bytes, model), Charset.forName(ofModel));
    assertThat(filled).contains("x=\"0;1\" y=\"0.5;2.75\"");
  }
}
