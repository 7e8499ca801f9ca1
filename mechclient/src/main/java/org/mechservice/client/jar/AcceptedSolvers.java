package org.mechservice.client.jar;

import java.security.PublicKey;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArraySet;
import org.mechservice.orb.tls.DetachedSignature;

/**
 * The keys that a user has accepted for solvers: what they have signed runs in the user's process
 * with all rights. None at first. Thread-safe.
 */
public final class AcceptedSolvers {
  private final Set<PublicKey> keys = new CopyOnWriteArraySet<>();

  /** Accepts what a key has signed. */
  public void accept(PublicKey key) {
    keys.add(key);
  }

  /** Returns whether there is a key. */
  boolean isAny() {
    return !keys.isEmpty();
  }

  /** Returns whether one of the keys has signed a JAR. */
  boolean haveSigned(byte[] jar, byte[] signature) {
    return keys.stream().anyMatch(key -> DetachedSignature.fits(key, jar, signature));
  }
}
