package org.robonewbie.simulator.state;

import java.util.Arrays;
import java.util.zip.CRC32;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * Immutable state of a world between two steps.
 *
 * <pre>{@code
 * WorldState start = world.save();
 * tryIt(world);
 * world.restore(start);
 * }</pre>
 *
 * <p>A state can be restored only in a world with the same settings, so it contains them. The binary format starts with
 * {@code RNSTATE}, the format version and a CRC-32 checksum of the rest: the settings as text, then the saved data.
 */
public final class WorldState {

    /** Format version. Increment it whenever the format of the saved data changes. */
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
     * @param settings settings that must match when the state is restored, one per line
     * @param world the world
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
     * @param world the world
     * @throws IllegalArgumentException if the settings differ or the saved data does not fit the world
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
     * @param bytes the result of {@link #toBytes()}
     * @return the state
     * @throws IllegalArgumentException if the bytes are not a state in this format version or are damaged
     */
    public static WorldState ofBytes(byte[] bytes) {
        int mismatch = Arrays.mismatch(MAGIC, bytes);
        if (mismatch >= 0 && mismatch < MAGIC.length) {
            throw new IllegalArgumentException(
                    mismatch == MAGIC.length - 1 && bytes.length > mismatch
                            ? "The saved state has version " + bytes[mismatch]
                                    + ", but this version of RoboNewbie reads only version "
                                    + VERSION + ". Save the state again."
                            : "This is not a saved world state (byte " + mismatch + "). Choose another file.");
        }
        StateReader in = new StateReader(bytes, MAGIC.length);
        if (in.getLong() != checksum(bytes, MAGIC.length + Long.BYTES)) {
            throw in.damaged("does not match its checksum");
        }
        WorldState state = new WorldState(in.getText(), in.getBytes());
        in.finish();
        return state;
    }

    /** {@return the state in binary form; equal states give equal bytes} */
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
