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
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * A log in the format of rcssserver3d for replay in RoboViz and rcssmonitor3d. A line with a monitor message is written
 * every 0.2 s: a full message at least every 3 s and whenever the scene has changed, otherwise a partial one.
 *
 * <p>Each line is flushed, so the log is valid even if the server is killed.
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

    MonitorLog(String name, OutputStream out, SoccerParameters parameters, Consumer<String> console) {
        this.name = name;
        this.out = out;
        this.console = console;
        scene = new SoccerScene(parameters);
        writer = new MonitorMessageWriter(MatchEnvironment.of(parameters));
    }

    /**
     * Creates a log file, replacing an existing one.
     *
     * @param file the file
     * @param parameters pitch and rules
     * @param console output for messages to the user
     * @return the log
     * @throws IOException if the file cannot be written; the message says what to do
     */
    public static MonitorLog open(Path file, SoccerParameters parameters, Consumer<String> console) throws IOException {
        try {
            OutputStream out = new BufferedOutputStream(Files.newOutputStream(file));
            return new MonitorLog(file.toString(), out, parameters, console);
        } catch (IOException e) {
            throw new IOException(
                    "Log \"" + file + "\" cannot be written (" + e.getMessage()
                            + "). Choose a file in an existing folder that you may write to.",
                    e);
        }
    }

    /**
     * Writes a line if one is due. Call only on the simulation thread.
     *
     * @param cycle number of the cycle
     * @param snapshot supplies the snapshot if needed
     */
    public void cycleEnded(long cycle, Supplier<MonitorSnapshot> snapshot) {
        if (open && cycle % CYCLES_PER_LINE == 0) {
            write(cycle, snapshot.get());
        }
    }

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
                + "). Is the disk full? The simulation continues.");
    }
}
