package org.mechservice.solver.compact;

import java.util.List;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.Sampling;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.Vector3;

/** Conversion of a mechanism to bytes and back, without changing a bit of its numbers. */
public final class CompactForm {
  private CompactForm() {}

  /** Returns the bytes of a mechanism. */
  public static byte[] write(Mechanism mechanism) {
    return new RecordWriter()
        .write(mechanism.name())
        .write(mechanism.root())
        .write(mechanism.gravity())
        .write(mechanism.bodies())
        .write(mechanism.joints())
        .write(mechanism.motions())
        .write(mechanism.startRoles())
        .write(mechanism.closures())
        .write(mechanism.forces())
        .write(mechanism.parameters())
        .write(mechanism.events())
        .write(mechanism.furtherStates())
        .write(mechanism.samplings())
        .write(mechanism.armatures())
        .bytes();
  }

  /**
   * Returns the mechanism of bytes.
   *
   * @param bytes bytes from {@link #write}; not modified
   * @throws IllegalArgumentException S-067 if they are damaged or of another version
   */
  public static Mechanism read(byte[] bytes) {
    RecordReader reader = new RecordReader(bytes);
    Mechanism mechanism =
        new Mechanism(
            (String) reader.read(),
            (Root) reader.read(),
            (Vector3) reader.read(),
            list(reader, Body.class),
            list(reader, Joint.class),
            list(reader, PrescribedMotion.class),
            list(reader, StartRole.class),
            list(reader, LoopClosure.class),
            list(reader, ForceElement.class),
            list(reader, Parameter.class));
    return mechanism
        .withEvents(list(reader, Event.class))
        .withFurtherStates(list(reader, FurtherState.class))
        .withSamplings(list(reader, Sampling.class))
        .withArmatures(list(reader, Armature.class));
  }

  private static <T> List<T> list(RecordReader reader, Class<T> type) {
    return ((List<?>) reader.read()).stream().map(type::cast).toList();
  }
}
