package org.robonewbie.app.soak;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.concurrent.Callable;

/**
 * An agent that comes again and again, plays for a while, and then crashes within a message, falls silent, floods the server or leaves. In each
 * life it leaves a monitor behind that never reads.
 */
final class Rogue implements Callable<Integer> {

    private static final int FLOOD = 300;
    private static final int LIVES_PER_SILENCE = 8;
    private static final int MAX_MESSAGE_BYTES = 1 << 20;

    private final int agentPort;
    private final int monitorPort;
    private final int number;
    private final int mostCycles;
    private final Random random;

    /**
     * Creates the agent.
     *
     * @param mostCycles it plays so many cycles at most before it does its worst
     */
    Rogue(int agentPort, int monitorPort, int number, int mostCycles) {
        this.mostCycles = mostCycles;
        this.agentPort = agentPort;
        this.monitorPort = monitorPort;
        this.number = number;
        this.random = new Random(number);
    }

    /** Lives until the server has gone, and returns how often it has come. */
    @Override
    public Integer call() {
        int lives = 0;
        Socket monitor = new Socket();
        while (true) {
            try (Socket agent = new Socket(InetAddress.getLoopbackAddress(), agentPort)) {
                monitor.close();
                monitor = new Socket(InetAddress.getLoopbackAddress(), monitorPort);
                lives++;
                live(agent, lives);
            } catch (IOException gone) {
                if (!answers()) {
                    return lives;
                }
            }
        }
    }

    private boolean answers() {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), agentPort)) {
            return socket.isConnected();
        } catch (IOException gone) {
            return false;
        }
    }

    private void live(Socket agent, int life) throws IOException {
        DataOutputStream out = new DataOutputStream(agent.getOutputStream());
        InputStream in = agent.getInputStream();
        send(out, "(scene rsg/agent/nao/nao.rsg)(syn)");
        int cycles = 3 + random.nextInt(mostCycles);
        for (int cycle = 0; cycle < cycles; cycle++) {
            skipMessage(in);
            send(out, cycle == 0 ? "(init (unum " + number + ")(teamname Rogues))(syn)" : "(he1 1)(lle3 -2)(syn)");
        }
        if ((life + number) % LIVES_PER_SILENCE == 0) {
            in.transferTo(OutputStream.nullOutputStream()); // silent until the server has enough of it
        } else if (life % 3 == 0) {
            crash(agent, out);
        } else if (life % 3 == 1) {
            flood(out);
        }
    }

    private static void crash(Socket agent, DataOutputStream out) throws IOException {
        out.writeInt(1000);
        out.writeBytes("(he1 ");
        agent.setSoLinger(true, 0);
    }

    private static void flood(DataOutputStream out) throws IOException {
        String many = "(he1 1e308)(say x)(beam nan 0 0)((((".repeat(200);
        for (int i = 0; i < FLOOD; i++) {
            send(out, many + "(syn)");
        }
    }

    private static void skipMessage(InputStream in) throws IOException {
        byte[] prefix = in.readNBytes(Integer.BYTES);
        int length =
                prefix.length < Integer.BYTES ? -1 : ByteBuffer.wrap(prefix).getInt();
        if (length < 0 || length > MAX_MESSAGE_BYTES || in.readNBytes(length).length < length) {
            throw new IOException("The server has ended the connection.");
        }
    }

    /** In one piece: of two small ones the system keeps the second back until the other side has confirmed the first, 40 ms later. */
    private static void send(DataOutputStream out, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        out.write(ByteBuffer.allocate(Integer.BYTES + bytes.length)
                .putInt(bytes.length)
                .put(bytes)
                .array());
    }
}
