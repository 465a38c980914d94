package org.robonewbie.protocol.monitor;

/**
 * A light at the position of the enclosing transform.
 *
 * @param diffuse colour of the diffuse light
 * @param ambient colour of the ambient light
 * @param specular colour of highlights
 */
public record LightNode(Colour diffuse, Colour ambient, Colour specular) implements SceneNode {

    /**
     * A colour.
     *
     * @param red red component, 0 to 1
     * @param green green component, 0 to 1
     * @param blue blue component, 0 to 1
     * @param alpha opacity, 0 to 1
     */
    public record Colour(float red, float green, float blue, float alpha) {

        /**
         * Creates an opaque grey.
         *
         * @param brightness brightness, 0 to 1
         * @return the colour
         */
        public static Colour grey(float brightness) {
            return new Colour(brightness, brightness, brightness, 1);
        }
    }
}
