package org.mechservice.admin;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.omg.CORBA.IntHolder;
import org.omg.CORBA.SystemException;

/** Asks servers how they are, all at the same time, and waits for none longer than told. */
public final class ServerWatch implements AutoCloseable {
  private static final int PAGE = 200;

  private final ServiceOrb orb = ServiceOrb.client();
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread asking = new Thread(task, "mechservice-admin");
            asking.setDaemon(true);
            return asking;
          });

  /**
   * Asks servers for their state, hosts and simulations.
   *
   * @param addresses {@code host:port} or URL of each
   * @param patience longest wait
   * @return one reading per address, in the same order
   * @throws InterruptedException if the thread is interrupted while it waits
   */
  public List<ServerReading> read(List<String> addresses, Duration patience)
      throws InterruptedException {
    List<Future<ServerReading>> answers = new ArrayList<>();
    for (String address : addresses) {
      answers.add(threads.submit(() -> ask(address)));
    }
    long deadline = System.nanoTime() + patience.toNanos();
    List<ServerReading> readings = new ArrayList<>();
    for (int i = 0; i < answers.size(); i++) {
      readings.add(await(addresses.get(i), answers.get(i), deadline - System.nanoTime()));
    }
    return readings;
  }

  private static ServerReading await(String address, Future<ServerReading> answer, long nanos)
      throws InterruptedException {
    try {
      return answer.get(Math.max(0, nanos), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return new ServerReading.Silent(
          address, "S-032 the server at " + address + " did not answer in time");
    } catch (ExecutionException e) {
      throw new IllegalStateException("asking " + address + " failed", e.getCause());
    }
  }

  private ServerReading ask(String address) {
    try {
      MechAdmin admin = orb.connectAdmin(address);
      return new ServerReading.Answering(
          address, admin.getStatus(), Arrays.asList(admin.listHosts()), notEnded(admin));
    } catch (ServiceUnreachableException | IllegalArgumentException e) {
      return new ServerReading.Silent(address, String.valueOf(e.getMessage()));
    } catch (NotAuthorized e) {
      return new ServerReading.Silent(address, e.code + " " + e.text);
    } catch (SystemException e) {
      return new ServerReading.Silent(
          address, "S-031 the connection to the server at " + address + " is lost");
    }
  }

  private static List<SimSummary> notEnded(MechAdmin admin) throws NotAuthorized {
    List<SimSummary> running = new ArrayList<>();
    IntHolder total = new IntHolder();
    int offset = 0;
    while (true) {
      SimSummary[] page = admin.listSimulations(offset, PAGE, total);
      Arrays.stream(page).filter(ServerWatch::goesOn).forEach(running::add);
      offset += page.length;
      if (page.length == 0 || offset >= total.value) {
        return running;
      }
    }
  }

  private static boolean goesOn(SimSummary simulation) {
    return simulation.info.state.value() < SimState._SIM_DONE;
  }

  @Override
  public void close() {
    threads.shutdownNow();
    orb.close();
  }
}
