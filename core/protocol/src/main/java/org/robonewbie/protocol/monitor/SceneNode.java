package org.robonewbie.protocol.monitor;

/**
 * A node of the scene that monitors draw: a tree of transforms with meshes and lights in them.
 *
 * <p>A node remembers what of it was written last, so that the next message can omit what has not changed. A scene therefore
 * belongs to one stream of messages.
 */
public sealed interface SceneNode permits TransformNode, MeshNode, LightNode {}
