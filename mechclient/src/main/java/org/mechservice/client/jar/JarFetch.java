package org.mechservice.client.jar;

import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.SetUpCalls;
import org.mechservice.idl.JarInfo;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.RuntimeInfo;

/**
 * Fetches the JARs of a session's model, and accepts only JARs with the announced hash and, over
 * TLS, a valid signature.
 *
 * @param calls to the session's host
 * @param setUp calls that set the model up
 * @param session the session
 * @param cache stores the solver
 * @param origin checks that a JAR comes from the host
 */
public record JarFetch(
    RemoteCalls calls, SetUpCalls setUp, MechSim session, JarCache cache, JarOrigin origin) {

  /**
   * Builds a JAR of the model at the host.
   *
   * @param options of the model and its solver; not modified
   * @param facts overwritten with what the server reports of the set-up
   * @throws InvalidOptionException if an option cannot be used
   * @throws JarRefusedException if what arrives is not what was announced
   */
  public BuiltJar model(NameValue[] options, NameValueSeqHolder facts) {
    JarInfoHolder holder = new JarInfoHolder();
    byte[] jar = setUp.get(patient -> patient.prepareJar(options, holder, facts));
    JarInfo info = holder.value;
    origin.verified(jar, info.signature, "the model JAR");
    return BuiltJar.verified(jar, info);
  }

  /**
   * Returns the solver that a model needs, from the cache if it is there.
   *
   * @throws JarRefusedException if it is not the one the model names
   */
  public byte[] runtime(BuiltJar modelJar) {
    String sha256 = modelJar.runtimeSha256();
    byte[] runtimeJar = cache.get(sha256, () -> calls.get(() -> session.fetchRuntime(sha256)));
    if (origin.encrypted()) {
      RuntimeInfo runtime = calls.get(session::getRuntimeInfo);
      origin.verified(runtimeJar, runtime.signature, "the runtime JAR");
    }
    return runtimeJar;
  }
}
