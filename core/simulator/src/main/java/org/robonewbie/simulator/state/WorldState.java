package org.robonewbie.simulator.state;

import java.util.Arrays;
import java.util.zip.CRC32;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * The state of a world between two steps, immutable.
 *
 * <pre>{@code
 * WorldState start = world.save();
 * tryIt(world);
 * world.restore(start);
 * }</pre>
 *
 * <p>A state only fits a world with the same settings, so these are part of it. As bytes it begins with {@code RNSTATE}, the
 * version of the format, and a checksum (CRC-32) of all that follows: the settings as text, then the content.
 */
public final class WorldState {

    /** Version of the content; every change of what is saved needs a new one. */
    private static final byte VERSION = 1;

    private static final byte[] MAGIC = {'R', 'N', 'S', 'T', 'A', 'T', 'E', VERSION};

    private final String settings;
    private final byte[] content;

    private WorldState(String settings, byte[] content) {
        this.settings = settings;
        this.content = content;
    }

    /**
     * Saves a world.
     *
     * @param settings what must agree between this world and one that continues from the state, one setting per line
     * @param world what is saved
     * @return its state
     */
    public static WorldState of(String settings, Restorable world) {
        StateWriter out = new StateWriter();
        world.save(out);
        return new WorldState(settings, out.toBytes());
    }

    /**
     * Restores a world to this state.
     *
     * @param present the settings of the world
     * @param world what is restored
     * @throws IllegalArgumentException if the settings differ, or the content is that of another version
     */
    public void restore(String present, Restorable world) {
        if (!settings.equals(present)) {
            throw new IllegalArgumentException(difference(present));
        }
        StateReader in = new StateReader(content);
        world.restore(in);
        in.finish();
    }

    /**
     * Reads a state.
     *
     * @param bytes what {@link #toBytes()} made
     * @return the state
     * @throws IllegalArgumentException if the bytes are no state, of another version, or damaged; the message says where
     */
    public static WorldState ofBytes(byte[] bytes) {
        int wrong = Arrays.mismatch(MAGIC, bytes);
        if (wrong >= 0 && wrong < MAGIC.length) {
            throw new IllegalArgumentException(
                    wrong == MAGIC.length - 1 && bytes.length > wrong
                            ? "The saved state has version " + bytes[wrong] + ", and this RoboNewbie reads version "
                                    + VERSION + " only. Save it again."
                            : "This is no saved state of a world (byte " + wrong + "). Choose another file.");
        }
        StateReader in = new StateReader(bytes, MAGIC.length);
        if (in.getLong() != checksum(bytes, MAGIC.length + Long.BYTES)) {
            throw in.damaged("does not agree with its checksum");
        }
        WorldState state = new WorldState(in.getText(), in.getBytes());
        in.finish();
        return state;
    }

    /** {@return the state as bytes, equal for equal states} */
    public byte[] toBytes() {
        StateWriter body = new StateWriter();
        body.putText(settings);
        body.putBytes(content, content.length);
        byte[] rest = body.toBytes();
        StateWriter head = new StateWriter();
        head.putLong(checksum(rest, 0));
        byte[] bytes = Arrays.copyOf(MAGIC, MAGIC.length + Long.BYTES + rest.length);
        System.arraycopy(head.toBytes(), 0, bytes, MAGIC.length, Long.BYTES);
        System.arraycopy(rest, 0, bytes, MAGIC.length + Long.BYTES, rest.length);
        return bytes;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof WorldState state
                && settings.equals(state.settings)
                && Arrays.equals(content, state.content);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(content);
    }

    @Override
    public String toString() {
        return "state of " + content.length + " bytes";
    }

    private String difference(String present) {
        String[] saved = settings.split("\n", -1);
        String[] now = present.split("\n", -1);
        int line = Math.max(0, Arrays.mismatch(saved, now));
        return "The saved state belongs to a world with " + (line < saved.length ? saved[line] : "fewer settings")
                + ", but this one has " + (line < now.length ? now[line] : "fewer settings")
                + ". Start a world with the same settings.";
    }

    private static long checksum(byte[] bytes, int from) {
        CRC32 checksum = new CRC32();
        checksum.update(bytes, from, bytes.length - from);
        return checksum.getValue();
    }
}
