"""Restart files of one rank with values changed and the checksum of all particles made right again: what is behind that
checksum must notice them too."""
import struct

MAGIC, SEED, PRIME, ALL = 0x324d545f48505321, 1469598103934665603, 1099511628211, (1 << 64) - 1
END = len("LammpS RestartT") + 1


def hash_bytes(data):
    """As restart_block.h has it."""
    h = SEED
    for k in range(0, len(data), 8):
        h = ((h ^ int.from_bytes(data[k:k + 8], "little")) * PRIME) & ALL
        h ^= h >> 32
    return h


def rows(data):
    """Begin and end of the values of every particle."""
    for at in range(len(data) - END - 8):
        flag, n = struct.unpack_from("<2i", data, at)
        if 0 < flag < 200 and n > 0 and at + 8 + 8 * n + END == len(data):
            break
    at, end, found = at + 8, at + 8 + 8 * n, []
    while at < end:
        length = 8 * int(struct.unpack_from("<d", data, at)[0])
        found.append((at, at + length))
        at += length
    return found


def seal(data, places):
    """places: the rows of the file as it was written, whose lengths may be among what is damaged."""
    data = bytearray(data)
    block = next(at for at in range(len(data)) if data[at:at + 8] == struct.pack("<Q", MAGIC) and
                 data[at - 11:at - 4] == b"sph/tm\0")    # of fix sph/tm: style, size, block
    size = struct.unpack_from("<Q", data, block + 8)[0]
    total = sum(hash_bytes(data[a:b]) for a, b in places) & ALL
    struct.pack_into("<2d", data, block + 24 + 16, float(total >> 32), float(total & 0xffffffff))
    struct.pack_into("<Q", data, block + 16, hash_bytes(data[block + 24:block + 24 + size]))
    return bytes(data)
