package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.PlayMode;

/** Writes records, each preceded by its kind and length, to the stream of a recording. */
final class RecordSink {

    private final RecordingStream stream;
    private final ByteSink records = new ByteSink();
    private final ByteSink payload = new ByteSink();
    private byte[] lastGame = {};

    RecordSink(RecordingStream stream) {
        this.stream = stream;
    }

    /** Writes what every recording begins with. */
    void begin(List<String> header) {
        byte[] magic = RecordingFormat.MAGIC.getBytes(StandardCharsets.US_ASCII);
        records.putBytes(magic, magic.length);
        records.putUnsigned(RecordingFormat.VERSION);
        newPayload().putText(String.join("\n", header));
        put(RecordingFormat.HEADER);
        send();
    }

    /** Begins a record; {@link #put} ends it. */
    ByteSink newPayload() {
        payload.clear();
        return payload;
    }

    /** Ends the record that was begun last. */
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

    /** Hands all records since the last call to the stream. */
    void send() {
        stream.write(records);
        records.clear();
    }
}
