package org.mechservice.guard.worker;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;

/** What a worker is asked for arrives as it was sent. */
class WorkerOrderTest {
  private static RunRequest received(boolean strict, OptionalDouble maxDrift) throws IOException {
    RunSettings settings =
        new RunSettings(0, 2, 0.25, "ode113", 1e-10, 1e-12).withAccuracy(Accuracy.STRICT);
    RunRequest request = new RunRequest(settings, Set.of(ColumnGroup.ENERGY), strict, maxDrift);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    WorkerModel model = new WorkerModel("A", new TreeMap<>(), new TreeMap<>());
    new WorkerOrder(model, Map.of("p", "1"), request).write(new DataOutputStream(bytes));
    RunRequest read =
        WorkerOrder.read(model, new DataInputStream(new ByteArrayInputStream(bytes.toByteArray())))
            .request();
    assertThat(read).isEqualTo(request);
    return read;
  }

  @Test
  void rulesThatEndARunArrive() throws IOException {
    assertThat(received(true, OptionalDouble.of(1e-4)).maxDrift()).hasValue(1e-4);
    assertThat(received(false, OptionalDouble.empty()).maxDrift()).isEmpty();
  }

  private static CheckpointOrder received(CheckpointOrder sent) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    sent.write(new DataOutputStream(bytes));
    return CheckpointOrder.read(new DataInputStream(new ByteArrayInputStream(bytes.toByteArray())));
  }

  @Test
  void whatToGoOnFromArrives() throws IOException {
    CheckpointOrder none = new CheckpointOrder(true, "hash", Optional.empty());
    assertThat(received(none)).isEqualTo(none);
    byte[] saved = {1, 2, 3};
    CheckpointOrder some = received(new CheckpointOrder(false, "hash", Optional.of(saved)));
    assertThat(some.possible()).isFalse();
    assertThat(some.saved().orElseThrow()).isEqualTo(saved);
  }
}
