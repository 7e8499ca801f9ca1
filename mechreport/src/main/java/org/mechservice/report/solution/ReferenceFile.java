package org.mechservice.report.solution;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.Variable;

/**
 * The file a reference that was made is kept in, to every digit: a report that is taken up again
 * need not make it anew, and a reader can check it.
 */
public final class ReferenceFile {
  private static final int BEFORE_STATES = 4;
  private static final String GRID = "# output times, start, step, number: ";
  private static final String JUMPS = "# jumps of the state, s: ";
  private static final String SAID = "# ";

  private final Path file;
  private final String title;
  private final List<String> states;

  /**
   * @param purpose model, settings and versions in one line
   * @param description of the model, for the names of its states
   */
  public ReferenceFile(Path file, String purpose, ModelDescription description) {
    this.file = file;
    this.title = SAID + purpose;
    this.states = description.states().stream().map(Variable::name).toList();
  }

  /**
   * A reference with the output times it was made for.
   *
   * @param grid output times
   */
  public record Kept(Reference reference, RunGrid grid) {}

  /**
   * Returns the stored reference if it was made with the same settings.
   *
   * @throws IOException if the file cannot be read
   */
  public Optional<Kept> read() throws IOException {
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
    boolean same = lines.size() > 2 && lines.get(0).equals(title);
    return same ? Optional.of(parse(lines.subList(1, lines.size()))) : Optional.empty();
  }

  private static Kept parse(List<String> lines) {
    double[] grid = numbers(lines.get(0).substring(GRID.length()));
    double[] jumps = numbers(lines.get(1).substring(JUMPS.length()));
    List<String> said =
        lines.stream()
            .skip(2)
            .filter(line -> line.startsWith(SAID))
            .map(line -> line.substring(SAID.length()))
            .toList();
    double[][] rows =
        lines.stream()
            .filter(line -> !line.startsWith(SAID))
            .skip(1)
            .map(ReferenceFile::numbers)
            .toArray(double[][]::new);
    double[] amplification = column(rows, 3);
    Reference reference =
        new Reference(
            column(rows, 0),
            Arrays.stream(rows)
                .map(row -> Arrays.copyOfRange(row, BEFORE_STATES, row.length))
                .toArray(double[][]::new),
            column(rows, 1),
            column(rows, 2),
            Double.isNaN(amplification[0]) ? Optional.empty() : Optional.of(amplification),
            DoubleStream.of(jumps).boxed().toList(),
            said);
    return new Kept(reference, new RunGrid(grid[0], grid[1], (int) grid[2]));
  }

  private static double[] numbers(String list) {
    return list.isBlank()
        ? new double[0]
        : Arrays.stream(list.split(",", -1)).mapToDouble(Double::parseDouble).toArray();
  }

  private static double[] column(double[][] rows, int column) {
    return Arrays.stream(rows).mapToDouble(row -> row[column]).toArray();
  }

  /**
   * Keeps a reference; the file is there in full or not at all.
   *
   * @throws IOException if the file cannot be written
   */
  public void write(Reference reference, RunGrid grid) throws IOException {
    List<String> lines = new ArrayList<>();
    lines.add(title);
    lines.add(GRID + grid.start() + "," + grid.step() + "," + grid.rows());
    lines.add(
        JUMPS + reference.jumps().stream().map(String::valueOf).collect(Collectors.joining(",")));
    reference.sources().forEach(said -> lines.add(SAID + said));
    lines.add("t,floor,rounding,amplification," + String.join(",", states));
    for (int i = 0; i < reference.times().length; i++) {
      lines.add(row(reference, i));
    }
    Path whole = file.resolveSibling(file.getFileName() + ".new");
    Files.write(whole, lines, StandardCharsets.UTF_8);
    Files.move(whole, file, StandardCopyOption.REPLACE_EXISTING);
  }

  private static String row(Reference reference, int i) {
    StringJoiner row = new StringJoiner(",");
    row.add(Double.toString(reference.times()[i]));
    row.add(Double.toString(reference.floor()[i]));
    row.add(Double.toString(reference.rounding()[i]));
    row.add(Double.toString(reference.amplification().map(all -> all[i]).orElse(Double.NaN)));
    for (double component : reference.states()[i]) {
      row.add(Double.toString(component));
    }
    return row.toString();
  }
}
