package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelJarFile;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;

/** The library in process: a model is read, changed, simulated and analysed. */
class MechModelTest {
  @TempDir private Path folder = Path.of("");

  private static MechModel pendulum() throws Exception {
    return MechModel.read(Path.of("../examples/pendulum/pendulum.xml"));
  }

  @Test
  void rowsInMemoryAreThoseOfTheFile() throws Exception {
    Path csv = folder.resolve("pendulum.csv");
    pendulum().simulate(csv);
    List<String> lines = Files.readAllLines(csv);
    Trajectory rows = pendulum().simulate();
    Path again = folder.resolve("again.csv");
    rows.writeCsv(again);
    assertThat(again).hasSameBinaryContentAs(csv);
    assertThat(rows.rows()).isEqualTo(lines.size() - 1);
    List<String> names = rows.columns().stream().map(Variable::name).toList();
    assertThat(String.join(",", names)).isEqualTo(lines.get(0));
    double[] last = rows.column(names.get(1));
    String[] words = lines.get(lines.size() - 1).split(",", -1);
    assertThat(last[last.length - 1]).isEqualTo(Double.parseDouble(words[1]));
    assertThat(rows.values().isDirect()).isTrue();
    assertThat(rows.values().remaining()).isEqualTo(rows.rows() * names.size());
  }

  @Test
  void changesMakeOtherModelsAndLeaveTheFirst() throws Exception {
    MechModel first = pendulum();
    MechModel shorter = first.until(0.5).every(0.25).columns(ColumnGroup.ENERGY);
    Trajectory rows = shorter.simulate();
    assertThat(rows.time()).containsExactly(0, 0.25, 0.5);
    assertThat(rows.columns().stream().map(Variable::name)).contains("energy.kinetic");
    assertThat(first.simulate().rows()).isGreaterThan(3);
  }

  @Test
  void aStoppedRunKeepsItsRows() throws Exception {
    RunControl control = new RunControl();
    control.stop();
    Trajectory rows = pendulum().simulate(control);
    assertThat(rows.report().outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(rows.rows()).isEqualTo(1);
  }

  @Test
  void aSinkTakesTheRowsAsTheyArise() throws Exception {
    int[] count = {0};
    ResultSink counting =
        new ResultSink() {
          @Override
          public void begin(List<Variable> columns) {}

          @Override
          public void row(double[] values) {
            count[0]++;
          }
        };
    long rows = pendulum().simulate(counting, new RunControl(), Checkpoints.NONE).rows();
    assertThat(count[0]).isEqualTo(rows);
  }

  @Test
  void namesThatAreNotThereAreSaidAtOnce() throws Exception {
    assertThatThrownBy(() -> pendulum().set("nothing", 1))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("nothing");
    Trajectory rows = pendulum().until(0.1).simulate();
    assertThatThrownBy(() -> rows.column("nothing"))
        .hasMessageContaining("there is no column \"nothing\"; there are t, ");
  }

  @Test
  void aJarRunsByItself() throws Exception {
    Path jar = folder.resolve("pendulum.jar");
    pendulum().until(0.1).writeJar(jar);
    Model loaded = ModelJarFile.load(jar).model();
    assertThat(loaded.description().name()).isEqualTo("FiveBarPendulum");
    Path noJar = Files.writeString(folder.resolve("no.jar"), "text");
    assertThatThrownBy(() -> ModelJarFile.load(noJar)).isInstanceOf(IOException.class);
  }

  @Test
  void smallMotionsAndRestAreFoundInTheSameModel() throws Exception {
    assertThat(pendulum().equilibrium().rows()).isEqualTo(1);
    assertThat(pendulum().modes().rows()).isGreaterThanOrEqualTo(1);
    assertThat(pendulum().linearise().rows()).isGreaterThanOrEqualTo(1);
    assertThat(pendulum().check().text()).startsWith("FiveBarPendulum");
  }
}
