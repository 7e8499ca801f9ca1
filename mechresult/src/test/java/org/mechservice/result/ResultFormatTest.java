package org.mechservice.result;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.text.ResultFile;

@Tag("slow")
class ResultFormatTest {
  @TempDir private Path folder;

  private Path file(ResultFormat format) {
    return folder.resolve("r" + format.ending());
  }

  private static void assertSame(SignalTable table, List<double[]> rows) {
    assertThat(table.columns()).isEqualTo(ExampleRows.COLUMNS);
    assertThat(table.rows()).isEqualTo(rows.size());
    for (int row = 0; row < rows.size(); row++) {
      for (int column = 0; column < table.columns().size(); column++) {
        assertThat(Double.doubleToRawLongBits(table.values().get(column)[row]))
            .as("row %d, column %d", row, column)
            .isEqualTo(Double.doubleToRawLongBits(rows.get(row)[column]));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(ResultFormat.class)
  void everyFormatKeepsNamesUnitsAndEveryBitOfTheNumbers(ResultFormat format) throws IOException {
    ExampleRows.write(file(format), ExampleRows.rows());

    assertSame(SignalTable.read(file(format)), ExampleRows.rows());
  }

  /** 75 MB of numbers: more than a row group of Parquet and many blocks of the other formats. */
  @ParameterizedTest
  @EnumSource(names = {"MAT", "PARQUET"})
  void resultLargerThanABlockIsKeptWhole(ResultFormat format) throws IOException {
    int rows = 2_350_000;
    try (ResultFile result = new ResultFile(file(format), format)) {
      result.begin(ExampleRows.COLUMNS);
      for (int i = 0; i < rows; i++) {
        result.row(new double[] {i, i + 0.25, -i, 2.0 * i});
      }
      result.keep();
    }
    SignalTable table = SignalTable.read(file(format));
    assertThat(table.rows()).isEqualTo(rows);
    double[] second = IntStream.range(0, rows).mapToDouble(i -> i + 0.25).toArray();
    assertThat(Arrays.equals(table.values().get(1), second)).isTrue();
    double[] last = IntStream.range(0, rows).mapToDouble(i -> 2.0 * i).toArray();
    assertThat(Arrays.equals(table.values().get(3), last)).isTrue();
  }

  /**
   * Of a small file with any of its bytes changed, memory of the file's own kind is taken: with the
   * heap of these tests, an array that a tag or a footer claims would be an OutOfMemoryError.
   */
  @ParameterizedTest
  @EnumSource(ResultFormat.class)
  void damagedFileIsReadOrRefused(ResultFormat format) throws IOException {
    ExampleRows.write(file(format), ExampleRows.rows());
    byte[] whole = Files.readAllBytes(file(format));
    Random random = new Random(20240611);
    byte[][] claims = {
      {-1, -1, -1, 127}, {127, -1, -1, -1}, {0, 0, 0, 64}, {-1, -1, -1, -1}, {0, 0, 0, 0}
    };
    for (int i = 0; i < 1000; i++) {
      byte[] damaged = whole.clone();
      int changes = 1 + random.nextInt(3);
      for (int k = 0; k < changes; k++) {
        byte[] claim = claims[random.nextInt(claims.length)];
        int at = random.nextInt(damaged.length - claim.length) & -(1 + 3 * random.nextInt(2));
        System.arraycopy(claim, 0, damaged, at, random.nextInt(claim.length + 1));
        damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
      }
      Files.write(file(format), damaged);
      try {
        assertThat(SignalTable.read(file(format)).rows()).isLessThan(whole.length);
      } catch (IOException refused) {
        assertThat(refused.getMessage()).startsWith("S-177").doesNotContain("\n");
      }
    }
  }

  @ParameterizedTest
  @EnumSource(ResultFormat.class)
  void resultWithoutRowsIsReadable(ResultFormat format) throws IOException {
    ExampleRows.write(file(format), List.of());

    assertSame(SignalTable.read(file(format)), List.of());
  }

  @ParameterizedTest
  @EnumSource(ResultFormat.class)
  void sameRowsGiveTheSameBytes(ResultFormat format) throws IOException {
    Path other = folder.resolve("other" + format.ending());
    ExampleRows.write(file(format), ExampleRows.rows());
    ExampleRows.write(other, ExampleRows.rows());

    assertThat(file(format)).hasSameBinaryContentAs(other);
  }

  @ParameterizedTest
  @EnumSource(ResultFormat.class)
  void abandonedResultLeavesNoFile(ResultFormat format) throws IOException {
    try (ResultFile result = new ResultFile(file(format), format)) {
      result.begin(ExampleRows.COLUMNS);
      result.row(new double[] {0, 1, 2, 3});
    }
    assertThat(folder).isEmptyDirectory();
  }

  @ParameterizedTest
  @EnumSource(names = {"JSON", "MAT", "PARQUET"})
  void cutFileIsRefusedWithItsName(ResultFormat format) throws IOException {
    ExampleRows.write(file(format), ExampleRows.rows());
    byte[] whole = Files.readAllBytes(file(format));
    for (int length : new int[] {0, 5, 200, whole.length / 2, whole.length - 9}) {
      Files.write(file(format), Arrays.copyOf(whole, length));

      assertThatThrownBy(() -> SignalTable.read(file(format)))
          .as("%d bytes", length)
          .isInstanceOf(IOException.class)
          .hasMessageStartingWith("S-177 " + file(format));
    }
  }

  @Test
  void matFileRefusesAMatrixOfMoreThanTwoGigabytes() {
    assertThat(ResultFormat.MAT.refusal(2_600_000, 100)).isEmpty();
    assertThat(ResultFormat.MAT.refusal(2_700_000, 100).orElseThrow())
        .contains("2 GB", "2684354 rows of 100 columns", ".parquet");
    assertThat(ResultFormat.PARQUET.isLimited()).isFalse();
    assertThat(ResultFormat.CSV.isLimited()).isFalse();
  }

  @Test
  void unitsAreBesideTextAndInsideTheOthers() throws IOException {
    for (ResultFormat format : ResultFormat.values()) {
      Path own = Files.createDirectory(folder.resolve(format.name()));
      ExampleRows.write(own.resolve("r" + format.ending()), ExampleRows.rows());

      assertThat(names(own))
          .isEqualTo(
              format.unitsBeside()
                  ? List.of("r" + format.ending(), "r.units.json")
                  : List.of("r" + format.ending()));
    }
  }

  private static List<String> names(Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void tableWhoseTimeGoesBackIsRefused() throws IOException {
    Path csv = Files.writeString(folder.resolve("r.csv"), "t,x\n0,1\n2,1\n1,1\n");

    assertThatThrownBy(() -> SignalTable.read(csv)).hasMessageContaining("row 3 has 1.0");
  }

  @Test
  void rowWithAValueTooManyIsRefused() throws IOException {
    Path csv = Files.writeString(folder.resolve("r.csv"), "t,x\n0,1\n2,1,7\n");

    assertThatThrownBy(() -> SignalTable.read(csv))
        .hasMessageContaining("row 2 has 3 values for 2 columns");
  }
}
