package org.mechservice.guard;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.SortedMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.IntSupplier;
import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;

/**
 * A process with classes of users, as the program that needs their forces has it. Every number that
 * it sends is taken as a number and nothing else; one exchange at a time.
 */
@SuppressWarnings("EnumOrdinal") // both ends are of one build
final class RelayProcess {
  /** Exit status of Java after an {@link OutOfMemoryError}, with {@code ExitOnOutOfMemoryError}. */
  private static final int EXIT_OUT_OF_MEMORY = 3;

  private static final long DYING_SECONDS = 60;

  /** Far more than an honest force needs for one value of its load. */
  private static final Duration LONGEST_ANSWER = Duration.ofSeconds(60);

  private static final int MOST_ENTRIES = 1_000_000;
  private static final int MOST_NUMBERS = 9;
  private static final double MEGABYTE = 1e6;

  private final WorkerBounds bounds;
  private final Process process;
  private final DataOutputStream out;
  private final DataInputStream in;
  private final Patience patience;

  /** Forces of each loader whose classes the process has. */
  private final Map<Long, Integer> loaders = new HashMap<>();

  private final Queue<Handle> released = new ConcurrentLinkedQueue<>();

  /**
   * Starts a process behind the wall of this machine.
   *
   * @throws IOException if it cannot be started
   */
  RelayProcess(WorkerBounds bounds) throws IOException {
    this.bounds = bounds;
    process =
        Confinement.start(
            Confinement.ofThisMachine()
                .command(bounds, RelayMain.class, List.of())
                .redirectError(ProcessBuilder.Redirect.DISCARD));
    out = new DataOutputStream(new BufferedOutputStream(process.getOutputStream()));
    in = new DataInputStream(new BufferedInputStream(process.getInputStream()));
    patience = new Patience(process, LONGEST_ANSWER, "a class of the user");
  }

  boolean isAlive() {
    return process.isAlive() && patience.ended().isEmpty();
  }

  void end() {
    process.destroyForcibly();
  }

  /** What a class of a user has thrown, or why its process is gone, as text. */
  @SuppressWarnings("OverrideThrowableToString") // shown as the class of the user would be
  private static final class RelayedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final String described;

    RelayedException(String message, String described) {
      super(message, null, false, false);
      this.described = described;
    }

    @Override
    public String toString() {
      return described;
    }
  }

  private interface Exchange<T> {
    T with() throws IOException;
  }

  /** Holds a dialogue; a process that is gone or sends nonsense is the fault of its classes. */
  private synchronized <T> T exchange(Exchange<T> exchange) {
    patience.begin();
    try {
      return exchange.with();
    } catch (StreamCorruptedException e) {
      end();
      String why = "java.lang.Error: its process sent what makes no sense: " + e.getMessage();
      throw new RelayedException(why, why);
    } catch (IOException e) {
      String why = patience.ended().map(late -> "java.lang.Error: " + late).orElseGet(this::lost);
      throw new RelayedException(why, why);
    } finally {
      patience.end();
    }
  }

  private String lost() {
    try {
      if (process.waitFor(DYING_SECONDS, TimeUnit.SECONDS)) {
        return process.exitValue() == EXIT_OUT_OF_MEMORY
            ? String.format(
                "java.lang.OutOfMemoryError: its process may use %.0f MB",
                bounds.heapBytes() / MEGABYTE)
            : "java.lang.Error: its process ended with status " + process.exitValue();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return "java.lang.Error: its process does not answer any more";
  }

  /**
   * Makes a force.
   *
   * @param loader number of the loader, whose classes the process then has
   */
  Handle create(long loader, SortedMap<String, byte[]> classFiles, String className) {
    return exchange(
        () -> {
          releaseUnused();
          if (!loaders.containsKey(loader)) {
            loaders.put(loader, 0);
            out.writeByte(RelayMessage.CLASSES);
            out.writeLong(loader);
            out.writeInt(classFiles.size());
            for (Map.Entry<String, byte[]> file : classFiles.entrySet()) {
              out.writeUTF(file.getKey());
              out.writeInt(file.getValue().length);
              out.write(file.getValue());
            }
          }
          loaders.merge(loader, 1, Integer::sum);
          out.writeByte(RelayMessage.CREATE);
          out.writeLong(loader);
          out.writeUTF(className);
          out.flush();
          requireDone();
          return new Handle(loader, in.readInt());
        });
  }

  private void releaseUnused() throws IOException {
    for (Handle old = released.poll(); old != null; old = released.poll()) {
      out.writeByte(RelayMessage.RELEASE);
      out.writeInt(old.force);
      int left = loaders.merge(old.loader, -1, Integer::sum);
      if (left == 0) {
        loaders.remove(old.loader);
        out.writeByte(RelayMessage.RELEASE_CLASSES);
        out.writeLong(old.loader);
      }
    }
  }

  /** Reads the answer of a question. */
  private void requireDone() throws IOException {
    byte kind = in.readByte();
    if (kind == RelayMessage.THROWN) {
      String message = in.readUTF();
      throw new RelayedException(message, in.readUTF());
    } else if (kind != RelayMessage.DONE) {
      throw new StreamCorruptedException("a message of the kind " + kind);
    }
  }

  /** One force in the process. */
  final class Handle {
    private final long loader;
    private final int force;
    private final List<Set<Reads>> points = new ArrayList<>();

    /** Why a coordinate has no position, which depends on its joint alone. */
    private final Map<Integer, String> withoutPosition = new HashMap<>();

    private int coordinates;
    private int parameters;
    private int values;

    Handle(long loader, int force) {
      this.loader = loader;
      this.force = force;
    }

    /** Lets the process forget the force. */
    void release() {
      released.add(this);
    }

    /** Has the force declare what it reads, and passes each declaration on. */
    void declare(ForceDeclaration model) {
      exchange(
          () -> {
            out.writeByte(RelayMessage.DECLARE);
            out.writeInt(force);
            out.flush();
            while (pass(in.readByte(), model)) {
              out.flush();
            }
            return this;
          });
    }

    /** Returns whether the force goes on declaring. */
    private boolean pass(byte kind, ForceDeclaration model) throws IOException {
      switch (kind) {
        case RelayMessage.POINT -> {
          String body = in.readUTF();
          String point = in.readUTF();
          Set<Reads> reads = reads();
          answer(() -> model.point(body, point, reads.toArray(Reads[]::new)), reads);
        }
        case RelayMessage.POINT_AT -> {
          String body = in.readUTF();
          double x = in.readDouble();
          double y = in.readDouble();
          double z = in.readDouble();
          Set<Reads> reads = reads();
          answer(() -> model.pointAt(body, x, y, z, reads.toArray(Reads[]::new)), reads);
        }
        case RelayMessage.COORDINATE -> {
          String joint = in.readUTF();
          int component = in.readInt();
          coordinates += answer(() -> model.coordinate(joint, component));
        }
        case RelayMessage.PARAMETER -> {
          String name = in.readUTF();
          parameters += answer(() -> model.parameter(name));
        }
        case RelayMessage.VALUE -> {
          String name = in.readUTF();
          String unit = in.readUTF();
          values += answer(() -> model.value(name, unit));
        }
        case RelayMessage.DONE -> {
          return false;
        }
        case RelayMessage.THROWN -> {
          String message = in.readUTF();
          throw new RelayedException(message, in.readUTF());
        }
        default -> throw new StreamCorruptedException("a message of the kind " + kind);
      }
      return true;
    }

    private Set<Reads> reads() throws IOException {
      int bits = in.readInt();
      Set<Reads> reads = EnumSet.noneOf(Reads.class);
      for (Reads one : Reads.values()) {
        if ((bits >> one.ordinal() & 1) != 0) {
          reads.add(one);
        }
      }
      return reads;
    }

    private void answer(IntSupplier declared, Set<Reads> reads) throws IOException {
      if (answer(declared) == 1) {
        points.add(reads);
      }
    }

    /** Returns how many quantities are declared by it: 1, or 0 if the model refuses it. */
    private int answer(IntSupplier declared) throws IOException {
      int count = points.size() + coordinates + parameters + values;
      if (count >= MOST_ENTRIES) {
        throw new StreamCorruptedException("more than " + MOST_ENTRIES + " declarations");
      }
      try {
        int index = declared.getAsInt();
        out.writeByte(RelayMessage.ACCEPTED);
        out.writeInt(index);
        return 1;
      } catch (RuntimeException e) {
        out.writeByte(RelayMessage.DENIED);
        out.writeBoolean(e instanceof IllegalArgumentException);
        out.writeUTF(RelayMessage.clipped(String.valueOf(e.getMessage())));
        return 0;
      }
    }

    /** Evaluates the force. */
    void apply(ForceState state, ForceLoads loads) {
      exchange(
          () -> {
            out.writeByte(RelayMessage.APPLY);
            out.writeInt(force);
            send(state);
            requireDone();
            for (int p = 0; p < points.size(); p++) {
              loads.addForce(p, in.readDouble(), in.readDouble(), in.readDouble());
              loads.addTorque(p, in.readDouble(), in.readDouble(), in.readDouble());
            }
            for (int c = 0; c < coordinates; c++) {
              loads.addJointForce(c, in.readDouble());
            }
            for (int v = 0; v < values; v++) {
              loads.setValue(v, in.readDouble());
            }
            return this;
          });
    }

    private void send(ForceState state) throws IOException {
      out.writeDouble(state.time());
      for (int p = 0; p < parameters; p++) {
        out.writeDouble(state.parameter(p));
      }
      for (int c = 0; c < coordinates; c++) {
        sendCoordinate(state, c);
        out.writeDouble(state.rate(c));
      }
      double[] numbers = new double[MOST_NUMBERS];
      for (int p = 0; p < points.size(); p++) {
        for (Reads one : points.get(p)) {
          int count = RelayMain.read(state, p, one, numbers);
          for (int i = 0; i < count; i++) {
            out.writeDouble(numbers[i]);
          }
        }
      }
      out.flush();
    }

    private void sendCoordinate(ForceState state, int coordinate) throws IOException {
      double position = 0;
      if (!withoutPosition.containsKey(coordinate)) {
        try {
          position = state.coordinate(coordinate);
        } catch (IllegalStateException e) {
          withoutPosition.put(coordinate, String.valueOf(e.getMessage()));
        }
      }
      out.writeUTF(withoutPosition.getOrDefault(coordinate, ""));
      out.writeDouble(position);
    }

    /** Has the force add its derivatives. */
    void differentiate(ForceState state, ForceBlocks blocks) {
      exchange(
              () -> {
                out.writeByte(RelayMessage.DIFFERENTIATE);
                out.writeInt(force);
                send(state);
                requireDone();
                int count = in.readInt();
                if (count < 0 || count > MOST_ENTRIES) {
                  throw new StreamCorruptedException(count + " derivatives");
                }
                List<Runnable> added = new ArrayList<>();
                for (int i = 0; i < count; i++) {
                  added.add(derivative(blocks));
                }
                return added;
              })
          .forEach(Runnable::run);
    }

    private Runnable derivative(ForceBlocks blocks) throws IOException {
      byte kind = in.readByte();
      ForceBlocks.Load load = oneOf(ForceBlocks.Load.values());
      int on = in.readInt();
      if (kind == RelayMessage.BY_POINT) {
        Reads by = oneOf(Reads.values());
        int point = in.readInt();
        double[] block = numbers();
        return () -> blocks.byPoint(load, on, by, point, block);
      } else if (kind != RelayMessage.BY_COORDINATE) {
        throw new StreamCorruptedException("a derivative of the kind " + kind);
      }
      int coordinate = in.readInt();
      double[] byPosition = numbers();
      double[] byRate = numbers();
      return () -> blocks.byCoordinate(load, on, coordinate, byPosition, byRate);
    }

    private <T> T oneOf(T[] all) throws IOException {
      int index = in.readByte();
      if (index < 0 || index >= all.length) {
        throw new StreamCorruptedException("the number " + index + " of " + all.length);
      }
      return all[index];
    }

    private double[] numbers() throws IOException {
      int count = in.readInt();
      if (count < 0 || count > MOST_NUMBERS) {
        throw new StreamCorruptedException(count + " numbers");
      }
      double[] numbers = new double[count];
      for (int i = 0; i < count; i++) {
        numbers[i] = in.readDouble();
      }
      return numbers;
    }
  }
}
