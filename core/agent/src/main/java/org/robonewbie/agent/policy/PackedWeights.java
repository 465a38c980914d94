package org.robonewbie.agent.policy;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Decoder of the packed form of a layer's parameters, which {@link PolicyText} describes. */
final class PackedWeights {

    private static final int PLANES = 3;
    private static final int MANTISSA_BITS = 52;

    private PackedWeights() {}

    /**
     * Unpacks the parameters of a layer.
     *
     * @param text the packed parameters
     * @param table shape of the layer's parameters
     * @return the parameters, row by row
     * @throws IllegalArgumentException if the text is damaged
     */
    static double[] unpack(CharSequence text, Layer.Table table) {
        int weights = table.rows() * table.weights();
        int size = table.weights() + Float.BYTES * table.rows() * (table.biases() + 1) + PLANES * weights;
        ByteBuffer bytes = ByteBuffer.wrap(inflate(Base85.decode(text), size)).order(ByteOrder.LITTLE_ENDIAN);
        double[] factors = new double[table.weights()];
        for (int i = 0; i < factors.length; i++) {
            factors[i] = powerOfTwo(bytes.get());
        }
        double[] numbers = new double[table.size()];
        int planes = size - PLANES * weights;
        for (int i = 0; i < table.rows(); i++) {
            int first = i * table.columns();
            for (int j = 0; j < table.biases(); j++) {
                numbers[first + j] = bytes.getFloat();
            }
            double step = bytes.getFloat();
            for (int j = 0; j < table.weights(); j++) {
                int integer = integer(bytes, planes + i * table.weights() + j, weights);
                numbers[first + table.biases() + j] = step * factors[j] * integer;
            }
        }
        return numbers;
    }

    private static double powerOfTwo(int exponent) {
        return Double.longBitsToDouble((long) (exponent + Double.MAX_EXPONENT) << MANTISSA_BITS);
    }

    /** Returns a signed integer, whose three bytes are a plane apart and whose lowest bit is its sign. */
    private static int integer(ByteBuffer bytes, int index, int plane) {
        int zigzag = (bytes.get(index) & 0xFF)
                | (bytes.get(index + plane) & 0xFF) << 8
                | (bytes.get(index + 2 * plane) & 0xFF) << 16;
        return zigzag >>> 1 ^ -(zigzag & 1);
    }

    /** Decompresses exactly {@code size} bytes, whatever the stream would yield beyond them. */
    private static byte[] inflate(byte[] compressed, int size) {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(compressed);
            byte[] bytes = new byte[size + 1];
            int length = 0;
            int more = inflater.inflate(bytes);
            while (more > 0) {
                length += more;
                more = length < bytes.length ? inflater.inflate(bytes, length, bytes.length - length) : 0;
            }
            if (length != size || !inflater.finished()) {
                throw new IllegalArgumentException("The layer needs " + size + " bytes, but "
                        + (length > size ? "more" : String.valueOf(length)) + " are packed.");
            }
            return Arrays.copyOf(bytes, size);
        } catch (DataFormatException damaged) {
            throw new IllegalArgumentException("The packed weights are damaged.", damaged);
        } finally {
            inflater.end();
        }
    }
}
