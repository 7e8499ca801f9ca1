package org.mechservice.orb;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Optional;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.LimitExceededHelper;
import org.mechservice.idl.ModelFile;
import org.mechservice.orb.connection.InboundCall;
import org.mechservice.orb.connection.LimitedBuffers;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.IMP_LIMIT;
import org.omg.CORBA.MARSHAL;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.portable.InputStream;
import org.omg.CORBA.portable.InvokeHandler;
import org.omg.CORBA.portable.OutputStream;
import org.omg.CORBA.portable.ResponseHandler;
import org.omg.PortableServer.POA;
import org.omg.PortableServer.Servant;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A servant in its object adapter that watches requests. It answers requests that were too large
 * with {@link LimitExceeded}, before arguments are read, and tells their connections which peers
 * use objects that live as long as they are called.
 */
final class WatchedServant extends Servant implements InvokeHandler {
  private static final Logger LOG = LoggerFactory.getLogger(WatchedServant.class);
  private static final String DESTROY = "destroy";

  private final Servant servant;
  private final boolean leased;

  /**
   * @param servant made by the IDL compiler
   * @param leased whether the object lives as long as it is called
   */
  WatchedServant(Servant servant, boolean leased) {
    this.servant = servant;
    this.leased = leased;
  }

  /** Returns what the IDL compiler's servant does, for calls that no connection carries. */
  Servant watched() {
    return servant;
  }

  @Override
  public OutputStream _invoke(String operation, InputStream arguments, ResponseHandler answers) {
    long bytes = InboundCall.refusedBytes();
    if (bytes > 0) {
      return refused(operation, bytes, answers);
    }
    if (leased) {
      InboundCall.leased(!operation.equals(DESTROY));
    }
    try {
      return ((InvokeHandler) servant)._invoke(operation, arguments, answers);
    } catch (SystemException expected) {
      throw expected;
    } catch (RuntimeException e) {
      // A servant is guarded: arguments end too early, or are none, where the ORB does not look.
      LOG.debug("arguments of {} cannot be read", operation, e);
      throw new MARSHAL("the arguments of " + operation + " cannot be read");
    }
  }

  private OutputStream refused(String operation, long bytes, ResponseHandler answers) {
    String text =
        operation
            + " was sent at least "
            + bytes
            + " bytes; this server takes at most "
            + LimitedBuffers.MAX_MESSAGE_BYTES
            + " in one request";
    Optional<Method> known =
        Arrays.stream(servant.getClass().getMethods())
            .filter(method -> method.getName().equals(operation))
            .filter(
                method -> Arrays.asList(method.getExceptionTypes()).contains(LimitExceeded.class))
            .findFirst();
    if (known.isEmpty()) {
      throw new IMP_LIMIT(text);
    }
    boolean model = Arrays.asList(known.get().getParameterTypes()).contains(ModelFile.class);
    OutputStream out = answers.createExceptionReply();
    LimitExceededHelper.write(
        out,
        new LimitExceeded(
            (model ? MessageCode.MODEL_TOO_LARGE : MessageCode.LIMIT_EXCEEDED).code(),
            text,
            "messageBytes",
            LimitedBuffers.MAX_MESSAGE_BYTES,
            bytes));
    return out;
  }

  @Override
  public String[] _all_interfaces(POA adapter, byte[] id) {
    return servant._all_interfaces(adapter, id);
  }
}
