package org.mechservice.orb;

import org.omg.CORBA.Any;
import org.omg.CORBA.ORB;
import org.omg.CORBA.Policy;
import org.omg.CORBA.PolicyError;
import org.omg.CORBA.SetOverrideType;
import org.omg.Messaging.RELATIVE_RT_TIMEOUT_POLICY_TYPE;

/** Makes references whose calls have a timeout. */
final class CallTimeouts {
  /** Longest wait for the first answer, s: a process on a busy machine may take ten. */
  static final int SECONDS = 20;

  private static final long TIME_UNITS_PER_SECOND = 10_000_000; // CORBA counts in 100 ns

  private CallTimeouts() {}

  /** Returns the same reference, with calls that end with {@code TIMEOUT} when they take long. */
  static org.omg.CORBA.Object inTime(ORB orb, org.omg.CORBA.Object reference) {
    return within(SECONDS, orb, reference);
  }

  /** Returns the same reference, with calls that end with {@code TIMEOUT} after some seconds. */
  static org.omg.CORBA.Object within(int seconds, ORB orb, org.omg.CORBA.Object reference) {
    Any time = orb.create_any();
    time.insert_ulonglong(seconds * TIME_UNITS_PER_SECOND);
    try {
      Policy[] policies = {orb.create_policy(RELATIVE_RT_TIMEOUT_POLICY_TYPE.value, time)};
      return reference._set_policy_override(policies, SetOverrideType.ADD_OVERRIDE);
    } catch (PolicyError e) {
      throw new IllegalStateException(e);
    }
  }
}
