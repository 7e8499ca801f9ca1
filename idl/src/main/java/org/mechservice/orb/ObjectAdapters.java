package org.mechservice.orb;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.mechservice.idl.LeasedHelper;
import org.mechservice.orb.connection.Endpoint;
import org.omg.BiDirPolicy.BIDIRECTIONAL_POLICY_TYPE;
import org.omg.BiDirPolicy.BOTH;
import org.omg.BiDirPolicy.BidirectionalPolicyValueHelper;
import org.omg.CORBA.Any;
import org.omg.CORBA.ORB;
import org.omg.CORBA.Policy;
import org.omg.CORBA.PolicyError;
import org.omg.CORBA.UserException;
import org.omg.PortableServer.IdAssignmentPolicyValue;
import org.omg.PortableServer.LifespanPolicyValue;
import org.omg.PortableServer.POA;
import org.omg.PortableServer.Servant;
import org.omg.PortableServer.ThreadPolicyValue;

/** The object adapters of an ORB: one for objects found by name, one for those handed out. */
final class ObjectAdapters {
  private final ORB orb;
  private final POA root;
  private final POA handedOut;
  private final Endpoint endpoint;
  private final Map<ServiceKey, org.omg.CORBA.Object> published = new ConcurrentHashMap<>();
  private final List<PendingCalls> calls = new ArrayList<>();

  private ObjectAdapters(ORB orb, boolean orderedCalls) throws UserException {
    this.orb = orb;
    root = counted((POA) orb.resolve_initial_references("RootPOA"));
    handedOut =
        create(
            orderedCalls ? "Callbacks" : "Sessions",
            LifespanPolicyValue.TRANSIENT,
            orderedCalls
                ? ThreadPolicyValue.SINGLE_THREAD_MODEL
                : ThreadPolicyValue.ORB_CTRL_MODEL);
    root.the_POAManager().activate();
    byte[] anyId = new byte[] {0};
    endpoint =
        Endpoint.of(
            orb,
            orb.object_to_string(handedOut.create_reference_with_id(anyId, LeasedHelper.id())));
  }

  /**
   * Opens the ORB's port.
   *
   * @param orderedCalls whether the objects handed out are called one at a time, in the order of
   *     arrival
   */
  static ObjectAdapters open(ORB orb, boolean orderedCalls) {
    try {
      return new ObjectAdapters(orb, orderedCalls);
    } catch (UserException e) {
      throw new IllegalStateException("the ORB does not start", e);
    }
  }

  private POA create(String name, LifespanPolicyValue lifespan, ThreadPolicyValue threads)
      throws UserException {
    List<Policy> policies = new ArrayList<>();
    policies.add(root.create_lifespan_policy(lifespan));
    policies.add(root.create_id_assignment_policy(IdAssignmentPolicyValue.USER_ID));
    policies.add(root.create_thread_policy(threads));
    policies.add(bidirectional());
    return counted(root.create_POA(name, root.the_POAManager(), policies.toArray(Policy[]::new)));
  }

  private POA counted(POA adapter) {
    PendingCalls ofAdapter = new PendingCalls();
    ((org.jacorb.poa.POA) adapter)._addPOAEventListener(ofAdapter);
    synchronized (calls) {
      calls.add(ofAdapter);
    }
    return adapter;
  }

  private Policy bidirectional() throws PolicyError {
    Any both = orb.create_any();
    BidirectionalPolicyValueHelper.insert(both, BOTH.value);
    return orb.create_policy(BIDIRECTIONAL_POLICY_TYPE.value, both);
  }

  /** Makes servants reachable under the names of a server; once per ORB. */
  void publish(Map<ServiceKey, Servant> servants) {
    try {
      POA named =
          create(
              OrbProperties.SERVICE_POA,
              LifespanPolicyValue.PERSISTENT,
              ThreadPolicyValue.ORB_CTRL_MODEL);
      for (var entry : servants.entrySet()) {
        byte[] id = entry.getKey().key().getBytes(StandardCharsets.US_ASCII);
        named.activate_object_with_id(id, new WatchedServant(entry.getValue(), false));
        published.put(entry.getKey(), named.id_to_reference(id));
      }
    } catch (UserException e) {
      throw new IllegalStateException("the objects cannot be published", e);
    }
  }

  /**
   * Returns the reference of a published object.
   *
   * @throws IllegalStateException if it is not published
   */
  org.omg.CORBA.Object published(ServiceKey key) {
    org.omg.CORBA.Object reference = published.get(key);
    if (reference == null) {
      throw new IllegalStateException(key + " is not published");
    }
    return reference;
  }

  /** Returns where the objects of this ORB are reached. */
  Endpoint endpoint() {
    return endpoint;
  }

  /**
   * Makes a servant callable under a random, unguessable id: the reference is the right to call.
   */
  ActiveObject activate(Servant servant) throws UserException {
    byte[] id = UUID.randomUUID().toString().getBytes(StandardCharsets.US_ASCII);
    handedOut.activate_object_with_id(id, new WatchedServant(servant, true));
    return new ActiveObject(handedOut.id_to_reference(id), handedOut, id);
  }

  /** Returns the servant behind a reference this ORB handed out. */
  Servant servantOf(org.omg.CORBA.Object reference) throws UserException {
    Servant found = handedOut.reference_to_servant(reference);
    return found instanceof WatchedServant watching ? watching.watched() : found;
  }

  /** Ends the object behind a reference this ORB handed out. */
  void deactivate(org.omg.CORBA.Object reference) throws UserException {
    new ActiveObject(reference, handedOut, handedOut.reference_to_id(reference)).close();
  }

  /** Refuses new calls and returns when those taken before have been answered. */
  void finishCalls() throws UserException {
    root.the_POAManager().discard_requests(true);
    counts().forEach(PendingCalls::awaitWorked);
  }

  /** Returns when the last call has been refused; the connections must be closed. */
  void awaitSilence() {
    counts().forEach(PendingCalls::awaitNone);
  }

  private List<PendingCalls> counts() {
    synchronized (calls) {
      return List.copyOf(calls);
    }
  }
}
