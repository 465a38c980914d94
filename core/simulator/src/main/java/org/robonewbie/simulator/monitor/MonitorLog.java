package org.robonewbie.simulator.monitor;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MonitorMessageWriter;

/**
 * A log in the format of rcssserver3d, which RoboViz and rcssmonitor3d replay: one monitor message per line each 0.2 s, a full one
 * at least every 3 s and whenever the scene has changed.
 *
 * <p>Each line is in the file as soon as it is written, so a server that dies leaves a good log.
 */
public final class MonitorLog implements AutoCloseable {

    private static final int CYCLES_PER_LINE = 10;
    private static final int CYCLES_PER_FULL_LINE = 150;

    private final String name;
    private final OutputStream out;
    private final Consumer<String> console;
    private final SoccerScene scene;
    private final MonitorMessageWriter writer;
    private long nextFullLine;
    private boolean open = true;

    private MonitorLog(String name, OutputStream out, MonitorSettings settings, Consumer<String> console) {
        this.name = name;
        this.out = out;
        this.console = console;
        scene = new SoccerScene(settings.field(), settings.ballRadius());
        writer = new MonitorMessageWriter(settings.environment());
    }

    /**
     * Begins a log; a file of the same name is replaced.
     *
     * @param file the file
     * @param settings what to tell
     * @param console takes sentences for people
     * @return the log
     * @throws IOException if the file cannot be written; the message says what to do
     */
    public static MonitorLog open(Path file, MonitorSettings settings, Consumer<String> console) throws IOException {
        try {
            OutputStream out = new BufferedOutputStream(Files.newOutputStream(file));
            return new MonitorLog(file.toString(), out, settings, console);
        } catch (IOException e) {
            throw new IOException(
                    "Log \"" + file + "\" cannot be written (" + e.getMessage()
                            + "). Choose a file in an existing folder that you may write to.",
                    e);
        }
    }

    /** Begins a log that goes to a stream. */
    static MonitorLog to(OutputStream out, MonitorSettings settings) {
        return new MonitorLog("", out, settings, problem -> {});
    }

    /**
     * Writes a line if it is time for it. To be called on the simulation's thread only.
     *
     * @param cycle number of the cycle
     * @param snapshot makes the snapshot, if needed
     */
    public void cycleEnded(long cycle, Supplier<MonitorSnapshot> snapshot) {
        if (open && cycle % CYCLES_PER_LINE == 0) {
            write(cycle, snapshot.get());
        }
    }

    /** Ends the log. */
    @Override
    public void close() {
        open = false;
        try {
            out.close();
        } catch (IOException e) {
            warn(e);
        }
    }

    private void write(long cycle, MonitorSnapshot snapshot) {
        boolean full = scene.update(snapshot) || cycle >= nextFullLine;
        if (full) {
            nextFullLine = cycle + CYCLES_PER_FULL_LINE;
        }
        MessageBuffer line = full
                ? writer.writeFull(snapshot.game(), snapshot.fouls(), scene.nodes())
                : writer.writePartial(snapshot.game(), snapshot.fouls(), scene.nodes());
        try {
            out.write(line.bytes(), 0, line.length());
            out.write('\n');
            out.flush();
        } catch (IOException e) {
            open = false;
            warn(e);
        }
    }

    private void warn(IOException cause) {
        console.accept("The log " + name + " ends here because it cannot be written (" + cause.getMessage()
                + "). Is the disk full? The simulation goes on.");
    }
}
