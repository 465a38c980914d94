package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.robonewbie.nao.PlayMode;

/** A writer of records, each preceded by its kind and length. It also computes the checksum of the recording. */
final class RecordSink {

    private final RecordingTarget target;
    private final MessageDigest digest;
    private final ByteSink records = new ByteSink();
    private final ByteSink payload = new ByteSink();
    private byte[] lastGame = {};

    RecordSink(RecordingTarget target) {
        this.target = target;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("This Java runtime does not provide SHA-256", e);
        }
    }

    /** Writes the magic bytes, the version and the header. */
    void begin(List<String> header) {
        byte[] magic = RecordingFormat.MAGIC.getBytes(StandardCharsets.US_ASCII);
        records.putBytes(magic, magic.length);
        records.putUnsigned(RecordingFormat.VERSION);
        newPayload().putText(String.join("\n", header));
        put(RecordingFormat.HEADER);
        send();
    }

    /** Starts a record and returns the buffer for its contents; {@link #put} ends the record. */
    ByteSink newPayload() {
        payload.clear();
        return payload;
    }

    /** Ends the current record. */
    void put(int kind) {
        records.putByte(kind);
        records.putUnsigned(payload.length());
        records.putBytes(payload.bytes(), payload.length());
    }

    void putEvent(String text) {
        newPayload().putText(text);
        put(RecordingFormat.EVENT);
    }

    /** Writes the state of the game if it has changed. */
    void putGame(PlayMode playMode, int half, int scoreLeft, int scoreRight, String teamLeft, String teamRight) {
        newPayload().putText(playMode.simSparkName());
        payload.putUnsigned(half);
        payload.putUnsigned(scoreLeft);
        payload.putUnsigned(scoreRight);
        payload.putText(teamLeft);
        payload.putText(teamRight);
        if (!Arrays.equals(payload.bytes(), 0, payload.length(), lastGame, 0, lastGame.length)) {
            lastGame = Arrays.copyOf(payload.bytes(), payload.length());
            put(RecordingFormat.GAME);
        }
    }

    /** Sends all records written since the previous call to the target. */
    void send() {
        digest.update(records.bytes(), 0, records.length());
        target.write(records.bytes(), records.length());
        records.clear();
    }

    String sha256() {
        try {
            return HexFormat.of().formatHex(((MessageDigest) digest.clone()).digest());
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException("The checksum cannot be read", e);
        }
    }
}
