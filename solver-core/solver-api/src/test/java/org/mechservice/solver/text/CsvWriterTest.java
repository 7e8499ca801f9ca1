package org.mechservice.solver.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.result.Variable;

class CsvWriterTest {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final CsvWriter csv = new CsvWriter(bytes);

  @Test
  void writesOneHeaderLineAndOneLinePerRowEndingInCrLf() throws IOException {
    csv.begin(List.of(new Variable("t", "s"), new Variable("j1.q", "rad")));
    csv.row(new double[] {0, 0.1});
    csv.row(new double[] {0.01, -1e-7});
    csv.close();
    assertThat(text()).isEqualTo("t,j1.q\r\n0,0.1\r\n0.01,-1e-7\r\n");
  }

  @Test
  void quotesNamesThatWouldBreakTheLine() throws IOException {
    csv.begin(List.of(new Variable("a,b.q", "m"), new Variable("say \"x\".q", "m")));
    csv.close();
    assertThat(text()).isEqualTo("\"a,b.q\",\"say \"\"x\"\".q\"\r\n");
  }

  @Test
  void everyNumberOfALongFileReadsBackExactly() throws IOException {
    Random random = new Random(3);
    double[][] rows = new double[3000][];
    csv.begin(List.of());
    for (int i = 0; i < rows.length; i++) {
      rows[i] = random.doubles(11, -1e3, 1e3).toArray();
      csv.row(rows[i]);
    }
    csv.close();
    String[] lines = text().split("\r\n", -1);
    for (int i = 0; i < rows.length; i++) {
      String[] cells = lines[i + 1].split(",", -1);
      for (int k = 0; k < cells.length; k++) {
        assertThat(Double.parseDouble(cells[k])).isEqualTo(rows[i][k]);
      }
    }
  }

  @Test
  void unitsAreAJsonObjectByColumnName() {
    assertThat(CsvWriter.unitsJson(List.of(new Variable("t", "s"), new Variable("a\"b", "m"))))
        .isEqualTo("{\n  \"t\": \"s\",\n  \"a\\\"b\": \"m\"\n}");
  }

  private String text() {
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
