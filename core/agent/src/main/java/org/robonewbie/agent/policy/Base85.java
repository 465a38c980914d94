package org.robonewbie.agent.policy;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** Decoder of bytes as text in the alphabet of RFC 1924, as Python's {@code base64.b85encode} writes them: five characters for four bytes. */
final class Base85 {

    private static final String ALPHABET =
            "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~";
    private static final int BASE = 85;
    private static final int CHARACTERS = 5;
    private static final int BYTES = 4;
    private static final long MAX_GROUP = 0xFFFF_FFFFL;
    private static final int[] DIGITS = digits();

    private Base85() {}

    private static int[] digits() {
        int[] digits = new int[128];
        Arrays.fill(digits, -1);
        for (int i = 0; i < BASE; i++) {
            digits[ALPHABET.charAt(i)] = i;
        }
        return digits;
    }

    /** Decodes a text. A last group of fewer than five characters is as if it were filled up with the highest digit. */
    static byte[] decode(CharSequence text) {
        int missing = (CHARACTERS - text.length() % CHARACTERS) % CHARACTERS;
        int groups = (text.length() + missing) / CHARACTERS;
        ByteBuffer bytes = ByteBuffer.allocate(groups * BYTES);
        for (int i = 0; i < groups; i++) {
            long group = 0;
            for (int j = i * CHARACTERS; j < (i + 1) * CHARACTERS; j++) {
                group = group * BASE + (j < text.length() ? digit(text.charAt(j)) : BASE - 1);
            }
            if (group > MAX_GROUP) {
                int start = i * CHARACTERS;
                throw new IllegalArgumentException("\""
                        + text.subSequence(start, Math.min(start + CHARACTERS, text.length()))
                        + "\" stands for no bytes.");
            }
            bytes.putInt((int) group);
        }
        return Arrays.copyOf(bytes.array(), Math.max(0, groups * BYTES - missing));
    }

    private static int digit(char character) {
        int digit = character < DIGITS.length ? DIGITS[character] : -1;
        if (digit < 0) {
            throw new IllegalArgumentException("\"" + character + "\" does not occur in packed weights.");
        }
        return digit;
    }
}
