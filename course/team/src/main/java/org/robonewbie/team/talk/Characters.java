package org.robonewbie.team.talk;

import java.util.Optional;

/**
 * Bit stream that is encoded as the text of a voice message. Such a message has at most 20 characters; spaces and
 * parentheses are forbidden, and quotation marks confuse some servers. Of the other characters, 64 are used, so each
 * holds six bits.
 *
 * <p>The last five bits are a checksum, so that messages from other programs are not mistaken for messages from this team.
 */
final class Characters {

    private static final String ALPHABET = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";
    private static final int BITS_PER_CHARACTER = 6;
    private static final int CHECK_BITS = 5;
    private static final int CHECKSUMS = 31;

    private final boolean[] bits;
    private final int key;
    private int next;

    /**
     * Creates an empty stream.
     *
     * @param length number of characters
     * @param key text on which the checksum depends; empty for none
     */
    Characters(int length, String key) {
        this.bits = new boolean[length * BITS_PER_CHARACTER];
        this.key = Math.floorMod(key.hashCode(), CHECKSUMS);
    }

    /** Decodes a message; empty if it has another length or another checksum. */
    static Optional<Characters> of(String text, int length, String key) {
        if (text.length() != length || text.chars().anyMatch(letter -> ALPHABET.indexOf(letter) < 0)) {
            return Optional.empty();
        }
        Characters result = new Characters(length, key);
        for (int i = 0; i < length; i++) {
            result.write(ALPHABET.indexOf(text.charAt(i)), BITS_PER_CHARACTER);
        }
        result.next = result.bits.length - CHECK_BITS;
        boolean right = result.read(CHECK_BITS) == result.checksum();
        result.next = 0;
        return right ? Optional.of(result) : Optional.empty();
    }

    /** Writes a non-negative integer with the given number of bits. */
    void write(int number, int width) {
        for (int bit = width - 1; bit >= 0; bit--) {
            bits[next++] = ((number >> bit) & 1) == 1;
        }
    }

    /**
     * Writes a number as an integer of the given number of bits, scaled between two limits. Values outside the limits are
     * clamped.
     */
    void write(double value, int width, double least, double most) {
        int steps = (1 << width) - 1;
        double share = (value - least) / (most - least);
        write((int) Math.floor(Math.max(0, Math.min(1, Double.isNaN(share) ? 0 : share)) * steps + 0.5), width);
    }

    /** Reads a non-negative integer with the given number of bits. */
    int read(int width) {
        int number = 0;
        for (int i = 0; i < width; i++) {
            number = 2 * number + (bits[next++] ? 1 : 0);
        }
        return number;
    }

    /** Reads a number that was written with the same width and limits. */
    double read(int width, double least, double most) {
        return least + (most - least) * read(width) / ((1 << width) - 1);
    }

    /** Appends the checksum and returns the encoded text. */
    String finish() {
        next = bits.length - CHECK_BITS;
        write(checksum(), CHECK_BITS);
        next = 0;
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < bits.length / BITS_PER_CHARACTER; i++) {
            text.append(ALPHABET.charAt(read(BITS_PER_CHARACTER)));
        }
        return text.toString();
    }

    private int checksum() {
        int sum = key;
        for (int i = 0; i < bits.length - CHECK_BITS; i++) {
            sum = (sum * 3 + (bits[i] ? i + 1 : 0)) % CHECKSUMS;
        }
        return sum;
    }
}
