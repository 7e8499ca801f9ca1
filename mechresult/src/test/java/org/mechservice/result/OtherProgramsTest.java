package org.mechservice.result;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.result.Variable;

/**
 * Other programs find the same names, units and bits in every format. The Python of the environment
 * variable MECH_PYTHON, or else {@code python3}, needs scipy, pandas, pyarrow and duckdb.
 */
class OtherProgramsTest {
  private static final String PYTHON =
      Optional.ofNullable(System.getenv("MECH_PYTHON")).orElse("python3");

  /** What each reader ends with: names, units, and a list of numbers for each column. */
  private static final String PRINT =
      """

      import struct
      print("|".join(names))
      print("|".join(units))
      for column in columns:
          print(" ".join(struct.pack(">d", float(x)).hex() for x in column))
      """;

  private static final Map<String, String> READERS = new HashMap<>();

  static {
    READERS.put(
        "pandas",
        """
        import json, sys, pandas
        # from 3.1 on pandas reads every bit by itself, and the option is deprecated
        old = tuple(map(int, pandas.__version__.split(".")[:2])) < (3, 1)
        exact = {"float_precision": "round_trip"} if old else {}
        d = pandas.read_csv(sys.argv[1], sep="\\t" if sys.argv[1].endswith(".tsv") else ",",
                            dtype=float, **exact)
        names = list(d.columns)
        beside = json.load(open(sys.argv[1][:-4] + ".units.json", encoding="utf-8"))
        units = [beside[n] for n in names]
        columns = [d[n] for n in names]
        """);
    READERS.put(
        "json",
        """
        import json, sys
        d = json.load(open(sys.argv[1], encoding="utf-8"))
        names = d["columns"]
        units = [d["units"][n] for n in names]
        columns = list(zip(*d["rows"]))
        """);
    READERS.put(
        "scipy.io",
        """
        import sys, scipy.io
        d = scipy.io.loadmat(sys.argv[1])
        names = [n[0].item() for n in d["names"]]
        units = [u[0].item() for u in d["units"]]
        columns = d["data"].T
        """);
    READERS.put(
        "pyarrow.parquet",
        """
        import json, sys, pyarrow.parquet
        d = pyarrow.parquet.read_table(sys.argv[1])
        names = d.column_names
        inside = json.loads(d.schema.metadata[b"units"])
        units = [inside[n] for n in names]
        columns = [d.column(n).to_pylist() for n in names]
        """);
    READERS.put(
        "duckdb",
        """
        import json, sys, duckdb
        d = duckdb.connect()
        rows = d.execute("SELECT * FROM read_parquet(?)", [sys.argv[1]])
        names = [c[0] for c in rows.description]
        columns = list(zip(*rows.fetchall()))
        inside = d.execute("SELECT value FROM parquet_kv_metadata(?) WHERE key = 'units'",
                           [sys.argv[1]]).fetchone()[0]
        inside = json.loads(bytes(inside).decode())
        units = [inside[n] for n in names]
        """);
  }

  @TempDir private Path folder;

  @CsvSource({
    "pandas, r.csv",
    "pandas, r.tsv",
    "json, r.json",
    "scipy.io, r.mat",
    "pyarrow.parquet, r.parquet",
    "duckdb, r.parquet"
  })
  @ParameterizedTest
  void pythonFindsTheSame(String library, String name) throws Exception {
    assumeTrue(runs(PYTHON, "-c", "import " + library), PYTHON + " has no " + library);
    Path file = folder.resolve(name);
    ExampleRows.write(file, ExampleRows.rows());

    String printed =
        output(PYTHON, "-X", "utf8", "-c", READERS.get(library) + PRINT, file.toString());

    assertThat(printed.lines().toList()).isEqualTo(expected());
  }

  @Test
  void octaveFindsTheSameInAMatFile() throws Exception {
    assumeTrue(runs("octave-cli", "--version"), "there is no octave-cli here");
    Path file = folder.resolve("r.mat");
    ExampleRows.write(file, ExampleRows.rows());
    String program =
        """
        load("%s");
        printf("%%d ", double(strjoin(names', "|"))); printf("\\n");
        printf("%%d ", double(strjoin(units', "|"))); printf("\\n");
        for column = data
          h = num2hex(column);
          c = cellstr(h);
          printf("%%s\\n", strjoin(c', " "));
        end
        """
            .formatted(file);

    List<String> printed =
        output("octave-cli", "--no-init-file", "--eval", program)
            .lines()
            .map(String::strip)
            .toList();

    List<String> expected = expected();
    // Of a letter outside ASCII Octave keeps the first byte of its UTF-8 form.
    expected.set(0, letters(expected.get(0).replace('ä', '\u00c3')));
    expected.set(1, letters(expected.get(1)));
    assertThat(printed).isEqualTo(expected);
  }

  /** Returns the numbers of the letters of a text. */
  private static String letters(String text) {
    return text.chars().mapToObj(Integer::toString).collect(Collectors.joining(" "));
  }

  private static List<String> expected() {
    List<String> lines = new ArrayList<>();
    lines.add(String.join("|", ExampleRows.COLUMNS.stream().map(Variable::name).toList()));
    lines.add(String.join("|", ExampleRows.COLUMNS.stream().map(Variable::unit).toList()));
    for (int column = 0; column < ExampleRows.COLUMNS.size(); column++) {
      int of = column;
      lines.add(
          String.join(
              " ",
              ExampleRows.rows().stream()
                  .map(row -> String.format("%016x", Double.doubleToRawLongBits(row[of])))
                  .toList()));
    }
    return lines;
  }

  private boolean runs(String... command) throws InterruptedException {
    try {
      Process process =
          new ProcessBuilder(command)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      return process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0;
    } catch (IOException e) {
      return false;
    }
  }

  private String output(String... command) throws IOException, InterruptedException {
    Path errors = folder.resolve("errors");
    Process process = new ProcessBuilder(command).redirectError(errors.toFile()).start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(Files.readString(errors)).isZero();
    return text;
  }
}
