package org.mechservice.server;

import java.lang.reflect.Proxy;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.mechservice.idl.IMechClientOperations;

/** The callbacks that a client has received: the last argument of each, as text. */
final class RecordedCallbacks {
  private final BlockingQueue<String> received = new LinkedBlockingQueue<>();

  /** Returns a client whose callbacks are recorded. */
  IMechClientOperations client() {
    return (IMechClientOperations)
        Proxy.newProxyInstance(
            IMechClientOperations.class.getClassLoader(),
            new Class<?>[] {IMechClientOperations.class},
            (proxy, method, arguments) -> {
              received.add(String.valueOf(arguments[arguments.length - 1]));
              return null;
            });
  }

  /** Waits until the end of a run is reported. */
  void awaitDone() throws InterruptedException {
    String last = "";
    while (!last.equals("done")) {
      last = String.valueOf(received.poll(1, TimeUnit.MINUTES));
    }
  }
}
