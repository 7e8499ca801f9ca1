package org.mechservice.load;

import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.RemoteRun;

/** A client in a process of its own: starts a run without end, says which, and takes its rows. */
final class EndlessClient {
  private EndlessClient() {}

  @SuppressWarnings("SystemOut") // how the test learns that the run goes on
  public static void main(String[] arguments) throws Exception {
    try (MechConnection connection = MechConnection.open(arguments[0], JarCache.ofUser());
        MechSession session = connection.openSession(arguments[1])) {
      session.loadModel(Runs.PENDULUM);
      try (RemoteRun run =
          session.prepareRemoteRun(SimulationOptions.asInFile().endTime(1e8).outputStep(10))) {
        run.start();
        System.out.println(run.id());
        run.toEnd(new Runs.Kept());
      }
    }
  }
}
