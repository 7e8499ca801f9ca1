package org.mechservice.sim.service.contract;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.Limit;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.orb.tls.Caller;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Logs refused calls. Each refused action is logged. A query that the same caller repeats, such as
 * an open console does, is logged once a minute with the number of its repetitions.
 */
public final class DenialLog {
  private static final long QUIET_NANOS = Duration.ofMinutes(1).toNanos();
  private static final int CALLERS_KEPT = 1000;
  private static final int LONGEST_ARGUMENT = 100;

  private final Journal journal;

  /** By caller and operation. */
  private final Map<String, Repeated> questions =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Repeated> eldest) {
          return size() > CALLERS_KEPT;
        }
      };

  private static final class Repeated {
    private long toldAt;
    private long untold;
  }

  public DenialLog(Journal journal) {
    this.journal = journal;
  }

  /** Logs a refused action. */
  void ofAction(Caller caller, String operation, Object[] arguments, NotAuthorized refusal) {
    log(caller, operation + "(" + shown(arguments) + ")", "", refusal);
  }

  /** Logs a refused query, unless it was logged less than a minute ago. */
  void ofQuestion(Caller caller, String operation, NotAuthorized refusal) {
    String key = caller.name("") + " " + caller.address().replaceFirst(":\\d+$", "") + operation;
    long before;
    synchronized (questions) {
      Repeated repeated = questions.get(key);
      long now = System.nanoTime();
      if (repeated != null && now - repeated.toldAt < QUIET_NANOS) {
        repeated.untold++;
        return;
      }
      before = repeated == null ? 0 : repeated.untold;
      Repeated told = new Repeated();
      told.toldAt = now;
      questions.put(key, told);
    }
    String often = before == 0 ? "" : " (and " + before + " times before)";
    log(caller, operation + "()", often, refusal);
  }

  private void log(Caller caller, String what, String often, NotAuthorized refusal) {
    String name = clean(caller.name(""));
    String text =
        "\"" + name + "\" (" + caller.roleName() + ") at " + caller.address() + " was refused ";
    journal.add(
        JournalEntry.warning(
                "denied", MessageCode.of(refusal.code), text + what + often + ": " + refusal.text)
            .inSession("", name));
  }

  private static String shown(Object[] arguments) {
    List<String> words = new ArrayList<>();
    for (Object argument : arguments) {
      if (argument instanceof Limit[] limits) {
        for (Limit limit : limits) {
          words.add(clean(limit.name) + "=" + limit.value);
        }
      } else if (argument instanceof HostInfo host) {
        words.add(clean(host.name));
      } else if (argument instanceof String || argument instanceof Number) {
        words.add(clean(argument.toString()));
      }
    }
    return String.join(", ", words);
  }

  /** Removes control characters, so that a caller cannot add lines to the log. */
  private static String clean(String text) {
    return ShortText.of(ShortText.name(text), LONGEST_ARGUMENT);
  }
}
