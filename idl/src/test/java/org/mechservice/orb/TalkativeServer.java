package org.mechservice.orb;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.omg.CORBA.SystemException;

/** Calls clients back from two threads each, as fast as it can, until they are gone. */
final class TalkativeServer implements AutoCloseable {
  private static final Progress PROGRESS =
      new Progress("sim", SimState.SIM_RUNNING, 0, 0, 0, 1, 1, 1, 1, 1, 1);

  private final EchoServer server;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final AtomicInteger talking = new AtomicInteger();

  private TalkativeServer(EchoServer server) {
    this.server = server;
  }

  static TalkativeServer start() {
    EchoServer server = EchoServer.start();
    TalkativeServer talkative = new TalkativeServer(server);
    server.onSession(talkative::talkTo);
    return talkative;
  }

  String address() {
    return server.address();
  }

  private void talkTo(IMechClient client) {
    talk(() -> client.onProgress(PROGRESS));
    talk(client::heartbeat);
  }

  private void talk(Runnable call) {
    talking.incrementAndGet();
    threads.execute(
        () -> {
          try {
            while (true) {
              call.run();
            }
          } catch (SystemException gone) {
            talking.decrementAndGet();
          }
        });
  }

  /** Returns how many threads still talk. */
  int talking() {
    return talking.get();
  }

  @Override
  public void close() {
    server.close();
    threads.shutdown();
  }
}
