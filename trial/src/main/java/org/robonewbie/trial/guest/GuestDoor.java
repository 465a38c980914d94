package org.robonewbie.trial.guest;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robonewbie.trial.Performer;

/**
 * Admits agents of other processes to a trial: a port of this computer that speaks to them as a simulator does, so any agent
 * can join, whatever its language.
 *
 * <pre>{@code
 * try (GuestDoor door = GuestDoor.open(0, 10)) {
 *     Trial trial = Trial.served(scene, 1, door.await(() -> true));
 * }
 * }</pre>
 */
public final class GuestDoor implements AutoCloseable {

    private static final int LOOK_MILLISECONDS = 100;
    private static final int MILLISECONDS_PER_SECOND = 1000;

    private final ServerSocket socket;
    private final double patienceSeconds;

    private GuestDoor(ServerSocket socket, double patienceSeconds) {
        this.socket = socket;
        this.patienceSeconds = patienceSeconds;
    }

    /**
     * Opens the door on 127.0.0.1.
     *
     * @param port its TCP port, 0 for any free one
     * @param patienceSeconds how long an agent may think about one message; 0 for as long as it likes, for debuggers
     * @return the open door
     * @throws IOException if the port is in use
     */
    public static GuestDoor open(int port, double patienceSeconds) throws IOException {
        ServerSocket socket = new ServerSocket(port, 0, InetAddress.getByAddress(new byte[] {127, 0, 0, 1}));
        socket.setSoTimeout(LOOK_MILLISECONDS);
        return new GuestDoor(socket, patienceSeconds);
    }

    /** {@return the TCP port for agents} */
    public int port() {
        return socket.getLocalPort();
    }

    /**
     * Waits for the next agent.
     *
     * @param expected asked again and again whether an agent may still come
     * @return the agent
     * @throws AbsentProgramException if it does not come any more
     */
    public Performer await(BooleanSupplier expected) {
        Optional<Performer> guest = Optional.empty();
        while (guest.isEmpty() && expected.getAsBoolean() && !socket.isClosed()) {
            guest = look();
        }
        return guest.orElseThrow(() -> new AbsentProgramException("The program ended before it asked for a robot."));
    }

    /** Waits a moment for an agent. */
    private Optional<Performer> look() {
        try {
            Socket guest = socket.accept();
            guest.setSoTimeout((int) (patienceSeconds * MILLISECONDS_PER_SECOND));
            return Optional.of(GuestPerformer.welcome(guest));
        } catch (SocketTimeoutException notYet) {
            return Optional.empty();
        } catch (IOException broken) {
            if (socket.isClosed()) {
                return Optional.empty();
            }
            throw new AbsentProgramException("The connection of the program broke before it had a robot.", broken);
        }
    }

    /** Admits no more agents; those inside may stay. */
    @Override
    public void close() {
        try {
            socket.close();
        } catch (IOException broken) {
            throw new AbsentProgramException("The door for agents cannot be closed.", broken);
        }
    }
}
