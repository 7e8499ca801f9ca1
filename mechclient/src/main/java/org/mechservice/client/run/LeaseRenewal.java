package org.mechservice.client.run;

import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.mechservice.idl.Leased;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Renews the leases of this client's objects at the server in the background, each after a third of
 * the granted time. A failed renewal is repeated every second; the next call of the user shows
 * whether the server is lost.
 */
public final class LeaseRenewal implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(LeaseRenewal.class);

  /** Time of the first renewal, whose answer contains the granted time. */
  private static final long FIRST_MILLIS = 500;

  private static final long RETRY_MILLIS = 1000;
  private static final long SHORTEST_MILLIS = 100;

  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread renewer = new Thread(task, "mechservice-leases");
            renewer.setDaemon(true);
            return renewer;
          });

  /** Keeps an object alive until the hold is closed. */
  public Hold hold(Leased object) {
    Hold hold = new Hold(object);
    hold.renewIn(FIRST_MILLIS);
    return hold;
  }

  @Override
  public void close() {
    thread.shutdownNow();
  }

  /** One object kept alive. */
  public final class Hold implements AutoCloseable {
    private final Leased object;
    private final AtomicBoolean released = new AtomicBoolean();

    private Hold(Leased object) {
      this.object = object;
    }

    @SuppressWarnings("FutureReturnValueIgnored") // nobody waits for a renewal
    private void renewIn(long millis) {
      try {
        thread.schedule(this::renew, millis, TimeUnit.MILLISECONDS);
      } catch (RejectedExecutionException e) {
        LOG.debug("the connection was closed while a lease was to be renewed", e);
      }
    }

    private void renew() {
      if (released.get()) {
        return;
      }
      try {
        long granted = TimeUnit.SECONDS.toMillis(object.renewLease());
        renewIn(Math.max(granted / 3, SHORTEST_MILLIS));
      } catch (OBJECT_NOT_EXIST e) {
        LOG.debug("the server has given up an object this client still holds", e);
      } catch (SystemException e) {
        LOG.debug("a lease could not be renewed; trying again", e);
        renewIn(RETRY_MILLIS);
      }
    }

    /** Stops renewing; the object lives as long as other clients renew it. */
    public void release() {
      released.set(true);
    }

    /** Stops renewing and destroys the object; if the server is lost, its lease ends by itself. */
    @Override
    public void close() {
      if (released.getAndSet(true)) {
        return;
      }
      try {
        object.destroy();
      } catch (SystemException e) {
        LOG.debug("an object could not be destroyed; its lease will end", e);
      }
    }
  }
}
