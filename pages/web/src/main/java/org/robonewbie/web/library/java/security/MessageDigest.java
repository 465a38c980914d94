package org.robonewbie.web.library.java.security;

import java.math.BigInteger;
import java.security.NoSuchAlgorithmException;

/** Subset of {@link java.security.MessageDigest} for the simulator: SHA-256 according to FIPS 180-4. */
public final class MessageDigest implements Cloneable {

    private static final int BLOCK_BYTES = 64;
    private static final int LENGTH_BYTES = 8;
    private static final int WORDS = 64;
    private static final int[] ROUNDS = fractionsOfRoots(WORDS, 3);

    private int[] state = fractionsOfRoots(8, 2);
    private byte[] block = new byte[BLOCK_BYTES];
    private int[] words = new int[WORDS];
    private int filled;
    private long length;

    private MessageDigest() {}

    /**
     * Creates a digest.
     *
     * @param algorithm name of the algorithm, which must be SHA-256
     * @return a digest that has received no input
     * @throws NoSuchAlgorithmException for other algorithms
     */
    public static MessageDigest getInstance(String algorithm) throws NoSuchAlgorithmException {
        if (!algorithm.equals("SHA-256")) {
            throw new NoSuchAlgorithmException(algorithm + " is not available on this page; only SHA-256 is.");
        }
        return new MessageDigest();
    }

    /**
     * Adds bytes.
     *
     * @param bytes the array
     * @param offset index of the first byte
     * @param count number of bytes
     */
    public void update(byte[] bytes, int offset, int count) {
        for (int i = offset; i < offset + count; i++) {
            add(bytes[i]);
        }
        length += count;
    }

    /** {@return the 32-byte digest of all bytes; no more bytes can be added afterwards} */
    public byte[] digest() {
        add((byte) 0x80);
        while (filled != BLOCK_BYTES - LENGTH_BYTES) {
            add((byte) 0);
        }
        long bits = length * Byte.SIZE;
        for (int i = LENGTH_BYTES - 1; i >= 0; i--) {
            add((byte) (bits >>> (i * Byte.SIZE)));
        }
        byte[] result = new byte[state.length * Integer.BYTES];
        for (int i = 0; i < result.length; i++) {
            result[i] = (byte) (state[i / Integer.BYTES] >>> ((Integer.BYTES - 1 - i % Integer.BYTES) * Byte.SIZE));
        }
        return result;
    }

    @Override
    public Object clone() throws CloneNotSupportedException {
        MessageDigest copy = (MessageDigest) super.clone();
        copy.state = state.clone();
        copy.block = block.clone();
        copy.words = words.clone();
        return copy;
    }

    private void add(byte value) {
        block[filled++] = value;
        if (filled == BLOCK_BYTES) {
            filled = 0;
            readWords();
            mix();
        }
    }

    private void readWords() {
        for (int i = 0; i < BLOCK_BYTES / Integer.BYTES; i++) {
            int at = i * Integer.BYTES;
            words[i] = block[at] << 24
                    | (block[at + 1] & 0xff) << 16
                    | (block[at + 2] & 0xff) << 8
                    | (block[at + 3] & 0xff);
        }
        for (int i = BLOCK_BYTES / Integer.BYTES; i < WORDS; i++) {
            int w15 = words[i - 15];
            int w2 = words[i - 2];
            int s0 = Integer.rotateRight(w15, 7) ^ Integer.rotateRight(w15, 18) ^ (w15 >>> 3);
            int s1 = Integer.rotateRight(w2, 17) ^ Integer.rotateRight(w2, 19) ^ (w2 >>> 10);
            words[i] = words[i - 16] + s0 + words[i - 7] + s1;
        }
    }

    private void mix() {
        int[] s = state.clone();
        for (int i = 0; i < WORDS; i++) {
            int sum1 = Integer.rotateRight(s[4], 6) ^ Integer.rotateRight(s[4], 11) ^ Integer.rotateRight(s[4], 25);
            int choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
            int first = s[7] + sum1 + choice + ROUNDS[i] + words[i];
            int sum0 = Integer.rotateRight(s[0], 2) ^ Integer.rotateRight(s[0], 13) ^ Integer.rotateRight(s[0], 22);
            int majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
            System.arraycopy(s, 0, s, 1, s.length - 1);
            s[4] += first;
            s[0] = first + sum0 + majority;
        }
        for (int i = 0; i < s.length; i++) {
            state[i] += s[i];
        }
    }

    /**
     * Returns the first 32 bits of the fractional parts of the square or cube roots of the first primes, the constants
     * of SHA-256.
     */
    private static int[] fractionsOfRoots(int count, int degree) {
        int[] fractions = new int[count];
        int prime = 2;
        for (int i = 0; i < count; prime++) {
            if (isPrime(prime)) {
                fractions[i++] = fractionOfRoot(prime, degree);
            }
        }
        return fractions;
    }

    private static boolean isPrime(int number) {
        for (int i = 2; i * i <= number; i++) {
            if (number % i == 0) {
                return false;
            }
        }
        return true;
    }

    /** Finds the root bit by bit: the largest r with r^degree at most prime · 2^(32 · degree). */
    private static int fractionOfRoot(int prime, int degree) {
        BigInteger power = BigInteger.valueOf(prime).shiftLeft(Integer.SIZE * degree);
        long root = 0;
        for (long bit = 1L << 40; bit > 0; bit >>= 1) {
            if (BigInteger.valueOf(root + bit).pow(degree).compareTo(power) <= 0) {
                root += bit;
            }
        }
        return (int) root;
    }
}
