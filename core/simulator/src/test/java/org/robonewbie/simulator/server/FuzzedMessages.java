package org.robonewbie.simulator.server;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;

/** Makes messages that are nearly right, from right ones and a seed. */
final class FuzzedMessages {

    static final List<String> OF_AGENTS = List.of(
            "(scene rsg/agent/nao/nao.rsg)",
            "(scene rsg/agent/nao/nao_hetero.rsg 4)(syn)",
            "(init (unum 2)(teamname Stars))(syn)",
            "(init (unum 0)(teamname Moons))",
            "(beam -3.5 1.25 45)",
            "(lae1 1.5)(rae1 -2.25)(lle3 0.5)(rle4 -0.75)(he1 6.1)(he2 -0.1)",
            "(say hello;world)(pass)(syn)",
            "(lle7 0.1)(rle7 -0.1)(syn)");

    static final List<String> OF_TRAINERS = List.of(
            "(kickOff Left)",
            "(playMode PlayOn)",
            "(playMode free_kick_right)",
            "(dropBall)",
            "(ball (pos 1 2 0.5)(vel 3 -1 2.5))",
            "(agent (unum 2)(team Left)(pos -3 2 0.5))",
            "(agent (unum 2)(team Left)(move -3 2 0.5 -90))",
            "(select (unum 2)(team Left))(repos)(agent (battery 4))",
            "(kill (unum 2)(team Left))",
            "(reqfullstate)(time 12.5)(score (left 2)(right 1))(getAck)(init)");

    private static final List<String> PIECES = List.of(
            "(",
            ")",
            "))",
            "((",
            "\"",
            "'",
            "'(",
            ";",
            " ",
            "\n",
            "\\",
            "nan",
            "-nan",
            "inf",
            "1e308",
            "-1e400",
            "1e-308",
            "99999999999999999999",
            "-0",
            ".",
            "-",
            "\u0000",
            "\u00ff",
            "(unum -1)",
            "(unum 1e9)",
            "(team None)",
            "(teamname ))",
            "(syn",
            "4294967296");

    private final Random random;
    private final List<String> patterns;

    FuzzedMessages(List<String> patterns, long seed) {
        this.patterns = patterns;
        this.random = new Random(seed);
    }

    /** Makes the bytes of one frame, the length of which is wrong now and then. */
    byte[] frame() {
        byte[] text = message().getBytes(StandardCharsets.ISO_8859_1);
        int length = random.nextInt(30) == 0 ? random.nextInt() >>> random.nextInt(32) : text.length;
        return ByteBuffer.allocate(4 + text.length).putInt(length).put(text).array();
    }

    /** Tells how many of the coming things to do before the client leaves. */
    int count(int most) {
        return 1 + random.nextInt(most);
    }

    private String message() {
        StringBuilder message = new StringBuilder();
        for (int i = count(3); i > 0; i--) {
            message.append(patterns.get(random.nextInt(patterns.size())));
        }
        for (int i = random.nextInt(5); i > 0; i--) {
            change(message);
        }
        return message.toString();
    }

    private void change(StringBuilder message) {
        int place = random.nextInt(message.length() + 1);
        int end = Math.min(message.length(), place + random.nextInt(8));
        switch (random.nextInt(5)) {
            case 0 -> message.delete(place, end);
            case 1 -> message.insert(place, message.substring(place, end).repeat(random.nextInt(50)));
            case 2 -> message.insert(place, PIECES.get(random.nextInt(PIECES.size())));
            case 3 -> message.replace(place, end, PIECES.get(random.nextInt(PIECES.size())));
            default -> message.insert(place, (char) random.nextInt(256));
        }
    }
}
